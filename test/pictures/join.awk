# join.awk - paths of one class become one where nothing that is painted between
# them overlaps, so that a picture has few lines and looks the same.

# box - of an outline, M and l, with a margin for its line
function box(d,    n, part, i, x, y, relative) {
    x0 = y0 = 1e9
    x1 = y1 = -1e9
    gsub(/[Mlz]/, " & ", d)
    gsub(/-/, " -", d)
    n = split(d, part, " +")
    for (i = 1; i <= n; i++) {
        if (part[i] ~ /^[Mlz]?$/) {
            if (part[i] != "") relative = part[i] == "l"
            continue
        }
        x = relative * x + part[i]
        y = relative * y + part[++i]
        if (x < x0) x0 = x
        if (x > x1) x1 = x
        if (y < y0) y0 = y
        if (y > y1) y1 = y
    }
    x0 -= 8
    y0 -= 8
    x1 += 8
    y1 += 8
}

# place - an outline into the last path of its class, or a new one
function place(c, d,    i, k) {
    box(d)
    for (i = paths; i > 0 && class[i] != c; i--) {
        for (k = 1; k <= many[i]; k++)
            if (x0 < right[i, k] && x1 > left[i, k] && y0 < top[i, k] &&
                y1 > low[i, k]) break
        if (k <= many[i]) i = 0
    }
    if (i <= 0) {
        class[i = ++paths] = c
        many[i] = 0
        data[i] = ""
    }
    data[i] = data[i] d
    k = ++many[i]
    left[i, k] = x0
    right[i, k] = x1
    low[i, k] = y0
    top[i, k] = y1
}

/^<path class="[a-zA-Z]*[0-9]*" d="[-Mlz0-9. ]*z"\/>$/ {
    split($0, quoted, "\"")
    outlines = split(quoted[4], outline, "z")
    for (j = 1; j < outlines; j++) place(quoted[2], outline[j] "z")
    next
}
{
    for (j = 1; j <= paths; j++)
        print "<path class=\"" class[j] "\" d=\"" data[j] "\"/>"
    paths = 0
    print
}
