#@ -Eprecision=400
# insphere_filter: as relative.g, N and P; and with the numbers h, right to H
# EPS of themselves, which count as H + 1 roundings more: HN and HP.
E = $EPS$;
U = 1 + E;
D = 1 - E;
need_C = ($U^N$ - 1) / (E * $D^P$);
need_C_h = ($U^HN$ - 1) / (E * $D^HP$);
{ need_C in ? /\ need_C_h in ?
  /\ (1 - $H$ * E) - (1 - E) * (1 - E) * (1 - E) * (1 - E) * (1 - E) >= 0 }
