# bounds.py - checks the table of all bounds of tess.c and hhpred.c; `make
# bounds' runs it.
#
#   python3 bounds.py [-s DIR] [-w PROGRAM] [-k DIR] [ROW...]
#   python3 bounds.py -n [-s DIR]
#
#   -s DIR      where tess.c and hhpred.c are (.)
#   -w PROGRAM  the program that searches for the worst case (none: a row that
#               needs it is unchecked)
#   -k DIR      keeps the scripts there, as Gappa got them
#   ROW...      only these rows
#   -n          tells only what is in no row
#
# Prints a line for each constant: row, constant, what its derivation needs, how
# many times that it is, and the verdict; then what is wrong.  Exit status 1 if
# a constant is unchecked, or anything is wrong.  README says what a row is.
import fractions
import os
import re
import subprocess
import sys

sys.dont_write_bytecode = True
import roundings  # pylint: disable=wrong-import-position

HERE = os.path.dirname(os.path.abspath(__file__))
FIELDS = ("row", "in", "code", "says", "constant", "formula", "derived",
          "assumes", "given", "atoms", "count", "check")
NEEDED = ("row", "constant", "formula", "derived", "check")
NUMBER = r"([0-9]+\.?[0-9]*(?:[eE][-+]?[0-9]+)?)[fFlL]?"
# Both kinds of double that the library knows, by the digits of one, and what
# scripts know of them: a bound on the relative error of one operation in any
# rounding mode, the least normal number, the half of what overflows.  A script
# with MODE in it is run for each of Gappa's names of the rounding modes.
FORMATS = {53: {"EPS": "1b-52", "MIN": "1b-1022", "MAX": "1b1023",
                "FORMAT": "53,-1074", "DIGITS": "53", "MOST": str(2 ** 53 - 1)},
           24: {"EPS": "1b-23", "MIN": "1b-126", "MAX": "1b127",
                "FORMAT": "24,-149", "DIGITS": "24", "MOST": str(2 ** 24 - 1)}}
MODES = ("ne", "up", "dn", "zr")

# What makes a number a bound's: the units of errors, small numbers, filters,
# and what multiplies an error.
UNITS = r"\b(?:F?EPS|(?:DBL|FLT)_EPSILON|ROUNDING|\w*UNDERFLOW\w*" \
    r"|LIST_DIST_ERR|HH_LENGTH_MIN|BELOW_HALF|RAISE_BELOW|CARRY|L_MAX" \
    r"|NEAR_BALL_MAX|HH_E_MAX|CENTRE_EXP_MAX|DBL_MIN|FLT_MIN|LEFT_LIST" \
    r"|STAR_REACH_MIN|LIST_BOX_MIN)\b"
TERM = r"[\w.>\[\]-]*?(?:\b|_)(?:err|dc|dl|dd|HH_E\]|HH_DC\]|err\[[^]]*\]|wide)"
TAINTED = [UNITS, r"(?<![\w.])[0-9][0-9.]*[eE]-[0-9]+",
           r"\bsign_if_certain\(", r"\bsign_of_limbs\([^()]*\)",
           NUMBER.replace("(", "(?:", 1) + r" \* " + TERM + r"(?![\w(])",
           r"\b" + TERM + r" \* " + NUMBER.replace("(", "(?:", 1)]

wrong = []


def fail(*words):
    wrong.append(" ".join(words))


def read_table(file):
    """The rows, each a dict of lists of texts; `name:' begins a field, a
    further line of it begins with a blank, an empty line ends the row."""
    rows = []
    row, last = None, None
    with open(file) as lines:
        for n, line in enumerate(lines, 1):
            if line.startswith("#"):
                continue
            if not line.strip():
                row = None
                continue
            if line[0] in " \t":
                row[last][-1] += " " + line.strip()
                continue
            last, _, text = line.strip().partition(":")
            if last not in FIELDS:
                sys.exit("%s:%d: no field %s" % (file, n, last))
            if last == "row":
                row = {name: [] for name in FIELDS}
                rows.append(row)
            if last == "code":  # with the place that stands before it
                text = row["in"][-1] + "\n" + text
            row[last].append(text.strip())
    return rows


def routines(text, digits):
    """The code of each routine of a file, by its name, and under - what is
    outside of all, without comments and in single blanks; of what the digits of
    a double decide, what holds for so many."""
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S).replace("\\\n", " ")
    kept, stack = [], []
    for line in text.split("\n"):
        word = re.match(r"#\s*(if|ifdef|ifndef|else|elif|endif)\b\s*(.*)", line)
        if word and word.group(1).startswith("if"):
            stack.append({"DBL_MANT_DIG >= 53": digits >= 53,
                          "DBL_MANT_DIG < 53": digits < 53}.get(
                              word.group(2).strip()))
        elif word and word.group(1) == "else" and stack[-1] is not None:
            stack[-1] = not stack[-1]
        elif word and word.group(1) == "endif":
            stack.pop()
        elif False not in stack:
            kept.append(line)
    parts, name = {"-": []}, "-"
    before = []
    for line in kept:
        if line.startswith("{"):
            head = " ".join(before).rsplit("(", 1)[0] if before else ""
            head = re.findall(r"(\w+)\s*\(", " ".join(before))
            name = head[0] if head else "-"
        if name == "-":
            before = before + [line] if line and line[0] not in "#}" else []
            if line.endswith(";"):
                before = []
        if name != "-" or line.startswith("#"):
            parts.setdefault(name, []).append(line)
        if line.startswith("}"):
            name, before = "-", []
    # (a line of its own ends a #define)
    return {name: re.sub(r"[ \t]*\n[ \t]*#", " ;#", "\n".join(lines)) and
            re.sub(r"\s+", " ", "\n".join(
                line + " ;" if line.startswith("#") else line
                for line in lines))
            for name, lines in parts.items()}


def pattern(code):
    """The expression for the code of a row: {NAME} stands for a number, and
    where a name comes again for the same number; ... for anything within a
    statement."""
    seen, out = set(), ""
    for part in re.split(r"(\{[A-Z]\w*\}|\.\.\.)", re.sub(r"\s+", " ", code)):
        if part == "...":
            out += r"[^;]*?"
        elif re.fullmatch(r"\{[A-Z]\w*\}", part):
            name = part[1:-1]
            out += "(?P=%s)[fFlL]?" % name if name in seen else \
                "(?P<%s>%s)[fFlL]?" % (name, NUMBER[1:-8])
            seen.add(name)
        else:
            out += re.escape(part)
    return re.compile(out)


def number(text):
    """An exact number: of decimal digits, or 1b-52, or a product or quotient
    of such."""
    value = fractions.Fraction(1)
    for operator, word in re.findall(r"(^|[*/])\s*([^*/\s]+)", text.strip()):
        mantissa, b, exponent = word.partition("b")
        factor = fractions.Fraction(mantissa)
        if b:
            factor *= fractions.Fraction(2) ** int(exponent)
        value = value / factor if operator == "/" else value * factor
    return value


def literal(value):
    """The same for Gappa: of a decimal number its digits and exponent."""
    value, places = fractions.Fraction(value), 0
    while value.denominator != 1 and places < 2000:
        value, places = value * 10, places + 1
    if value.denominator != 1:
        value /= 10 ** places
        return "(%d / %d)" % (value.numerator, value.denominator)
    return "%de-%d" % (value, places) if places else str(value)


def calculated(text, names):
    """The value of an expression of numbers and names of such."""
    if not re.fullmatch(r"[\w.+\-*/() ]+", text):
        raise ValueError(text)

    def value(word):
        word = names.get(word.group(0), word.group(0))
        return "F('%s')" % number(str(word))
    # pylint: disable=eval-used # numbers, names of such, and + - * / ( )
    return eval(re.sub(r"(?<![\w.])\d[\w.]*(?:(?<=[eb])-\d+)?|[A-Za-z_]\w*",
                       value, text), {"F": fractions.Fraction})


def by_digits(text):
    """`VALUE', or `VALUE (53), VALUE (24)': its value for both digits."""
    several = re.findall(r"([^,()]+)\((53|24)\)", text)
    if several:
        return {int(digits): number(value) for value, digits in several}
    return {digits: number(text) for digits in FORMATS}


def constants(row):
    """The constants of a row: name -> (value by digits, 1 if it must be at
    least what is needed, -1 if at most, 0 if nothing is, words for it)."""
    found = {}
    for text in row["constant"]:
        if text == "-":
            continue
        parsed = re.fullmatch(r"(\w+) = (.+?)(, at most|, given)?", text)
        if not parsed:
            fail(row["row"][0] + ": constant: " + text)
            continue
        found[parsed.group(1)] = (by_digits(parsed.group(2)),
                                  {None: 1, ", at most": -1,
                                   ", given": 0}[parsed.group(3)],
                                  parsed.group(2).split(" (")[0])
    return found


class Sources:
    def __init__(self, where):
        self.text = {}  # (file, digits) -> {routine: code}
        self.seen = {}  # (file, digits, routine) -> [(from, to)]
        self.row = {}  # (file, digits, routine, place) -> the constant's row
        self.words = {}  # file -> what its comments say
        self.macros = {}
        for name in ("hhpred.h", "hhpred.c", "tess.h", "tess.c"):
            with open(os.path.join(where, name)) as source:
                text = source.read()
            self.words[name] = re.sub(r"\s+", " ", re.sub(
                r"\n \* ?", "\n", " ".join(re.findall(
                    r"/\*(.*?)\*/", text, flags=re.S))))
            self.macros.update(roundings.macros_of(re.sub(
                r"/\*.*?\*/", " ", text, flags=re.S).replace("\\\n", " ")))
            for digits in FORMATS:
                self.text[name, digits] = routines(text, digits)

    def take(self, row, digits, known):
        """Finds the code of a row, and compares its constants."""
        name = row["row"][0]
        values = {}
        for code in row["code"]:
            place, _, code = code.partition("\n")
            file, _, routine = place.partition(" ")
            routine = routine.strip()
            text = self.text.get((file, digits), {}).get(routine)
            if text is None:
                fail(name + ": no routine " + place)
                continue
            found = list(pattern(code).finditer(text))
            if not found:
                fail("%s: not in %s (doubles of %d bits): %s" %
                     (name, place, digits, code))
            for match in found:
                self.seen.setdefault((file, digits, routine),
                                     []).append(match.span())
                for letter, value in match.groupdict().items():
                    value = number(value)
                    if values.setdefault(letter, value) != value:
                        fail(name + ": two values of " + letter)
                    at = (file, digits, routine, match.start(letter))
                    if known.get(letter, (0, 0))[1] and \
                            self.row.setdefault(at, name) != name:
                        fail("%s: %s is in row %s, too" %
                             (name, letter, self.row[at]))
        for says in row["says"]:
            file, _, says = says.partition(" ")
            found = pattern(says).search(self.words[file])
            if not found:
                fail("%s: no comment of %s says: %s" % (name, file, says))
                continue
            for letter, value in found.groupdict().items():
                if values.setdefault(letter, number(value)) != number(value):
                    fail(name + ": two values of " + letter)
        for letter, value in values.items():
            if letter not in known:
                fail(name + ": no constant " + letter)
            elif known[letter][0].get(digits) != value:
                fail("%s: %s is %s in the code, not as in the table" %
                     (name, letter, float(value)))
        return values

    def given(self, row, digits):
        given = dict.fromkeys(("EPS", "DBL_EPSILON", "FEPS", "FLT_EPSILON"),
                              fractions.Fraction(1, 2 ** (digits - 1)))
        for text in row["given"]:
            words, _, value = text.rpartition(" = ")
            given[words.replace(" ", "")] = fractions.Fraction(value)
        return given

    def sizes(self, row, digits, line):
        """A script's line `#size NAME = FILE ROUTINE: VALUE under T with
        INPUTS = SIZE; ...'."""
        name, file, routine, value, under, with_ = re.fullmatch(
            r"#size (\w+) = (\S+) (\w+): (.+) under (\S+) with (.*)",
            line).groups()
        inputs = [[w.strip() for w in part.split(" = ")]
                  for part in with_.split(";")]
        return roundings.sizes(
            name, self.text[file, digits][routine], self.macros,
            self.given(row, digits), " ".join(row["atoms"]).split(), value,
            under, inputs)

    def counts(self, row, digits):
        """What is counted for a row: for a letter the sum of all that is."""
        given = self.given(row, digits)
        out = {}
        for text in row["count"]:
            letter, _, asked = text.partition(" = ")
            if asked.isdigit():
                out[letter] = out.get(letter, 0) + int(asked)
                continue
            place, atoms = row["in"][0], " ".join(row["atoms"]).split()
            asked, _, when = asked.partition(" if ")
            if ":" in asked:
                place, _, asked = asked.partition(":")
                atoms = []
            file, _, routine = place.partition(" ")
            try:
                out[letter] = out.get(letter, 0) + roundings.count(
                    self.text[file, digits][routine.strip()], self.macros,
                    self.given({"given": row["given"] + [when]}, digits)
                    if when else given, atoms, asked.strip())[0]
            except (SyntaxError, KeyError) as error:
                fail("%s: %s: %s" % (row["row"][0], text, error))
        return out

    def uncovered(self):
        """What makes a number a bound's and is in no row."""
        for (file, digits), parts in self.text.items():
            for routine, text in parts.items():
                spans = self.seen.get((file, digits, routine), [])
                for sort in TAINTED:
                    for match in re.finditer(sort, text):
                        at = match.start()
                        if any(a <= at and match.end() <= b
                               for a, b in spans):
                            continue
                        yield "%s %s: %s" % (
                            file, routine,
                            text[max(0, at - 40):match.end() + 40])


def gappa(script, values, digits, keep, sizes):
    """Runs a script with the code's constants in it.  Returns 1 if all is
    proven, and the ends of what it asks for, `need_C in ?' or `need_C_...':
    all of one name together."""
    with open(os.path.join(HERE, "gappa", script)) as text:
        text = text.read()
    given = dict(FORMATS[digits])
    for letter, value in values.items():
        given[letter] = literal(value)
    try:
        text = re.sub(r"^#size .*(?:\n#     .*)*",
                      lambda line: sizes(line.group(0).replace("\n#", " ")),
                      text, flags=re.M)
    except SyntaxError as error:
        fail("%s: %s" % (script, error))
        return 0, {}
    for word in set(re.findall(r"[$]([^$\n]+)[$]", text)) - {"MODE"}:
        base, power, exponent = word.partition("^")
        try:
            if word[0] == "=":
                new = literal(calculated(word[1:], given))
            elif power:
                exponent = sum(int(given.get(n, n))
                               for n in exponent.split("+"))
                new = "(%s)" % " * ".join([base] * exponent or ["1"])
            else:
                new = given[word]
        except (KeyError, ValueError):
            fail(script + ": no constant " + word)
            return 0, {}
        text = text.replace("$%s$" % word, new)
    needs = {}
    for mode in MODES if "$MODE$" in text else ("",):
        if keep:
            with open(os.path.join(keep, "%d%s-%s" % (digits, mode, script)),
                      "w") as file:
                file.write(text.replace("$MODE$", mode))
        run = subprocess.run(
            ["gappa"], input=text.replace("$MODE$", mode), text=True,
            timeout=300, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        words = " ".join(line for line in run.stdout.split("\n")
                         if not line.startswith("Warning: renaming"))
        if run.returncode or "Warning" in words:
            fail("%s (doubles of %d bits%s): %s" %
                 (script, digits, mode and ", " + mode, words[:300]))
            return 0, {}
        for letter, low, high in re.findall(
                r"^\s*need_([A-Za-z0-9]+)\w* in \[([^ ,]+).* ([^ {}]+)"
                r"(?: \{[^{}]*\})?\]$", run.stdout, flags=re.M):
            low, high = number(low), number(high)
            if letter in needs:
                low = min(low, needs[letter][0])
                high = max(high, needs[letter][1])
            needs[letter] = (low, high)
    return 1, needs


def lemma(name):
    """What a lemma says is needed: lines `Needs C <= 7.5'."""
    found = None
    for file in sorted(os.listdir(HERE)):
        if file.endswith(".txt") and not found:
            with open(os.path.join(HERE, file)) as text:
                found = re.search(
                    r"^Lemma %s[.].*?(?=^Lemma |\Z)" % re.escape(name),
                    text.read(), flags=re.M | re.S)
    if not found:
        fail("no lemma " + name)
        return 0, {}
    return 1, {letter: by_digits(value) for letter, value in re.findall(
        r"^\s*Needs (\w+) [<>]= (.*)$", found.group(0), flags=re.M)}


def search(program, name):
    """The worst ratio, error over bound, that the program finds."""
    if not program:
        return 0, None
    run = subprocess.run([program, name], text=True, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT)
    found = re.search(r"^# %s: worst ratio (\S+)" % re.escape(name), run.stdout,
                      flags=re.M)
    if run.returncode or not found or not float(found.group(1)) < 1:
        fail("search %s: %s" % (name, run.stdout.strip()[-300:]))
        return 0, None
    return 1, float(found.group(1))


def main():
    options = {"-s": ".", "-w": "", "-k": ""}
    missing = "-n" in sys.argv
    only = [word for word in sys.argv[1:] if word != "-n"]
    while only and only[0] in options:
        options[only[0]] = only[1]
        only = only[2:]
    if options["-k"]:
        os.makedirs(options["-k"], exist_ok=True)
    table = [row for file in sorted(os.listdir(HERE))
             if file.endswith(".rows")
             for row in read_table(os.path.join(HERE, file))]
    sources = Sources(options["-s"])
    names = [row["row"][0] for row in table]
    for name in set(names):
        if names.count(name) > 1:
            fail(name + ": two rows")
    unchecked = 0
    for row in table:
        name = row["row"][0]
        for field in FIELDS:
            if not row[field] and field in NEEDED:
                fail("%s: no %s" % (name, field))
        known = constants(row)
        values = {digits: sources.take(row, digits, known)
                  for digits in FORMATS}
        if missing or (only and name not in only):
            continue
        needs, seen = {}, []  # letter -> [(value by digits, how)]
        for check in row["check"]:
            kind, _, what = check.partition(" ")
            what, _, which = what.partition(" ")
            sound, found = 1, {}
            how = {"gappa": "Gappa", "lemma": "lemma " + what}.get(kind)
            if kind == "gappa":
                for digits in FORMATS:
                    if which and which != str(digits):
                        continue
                    given = {letter: value[0][digits]
                             for letter, value in known.items()}
                    given.update(values[digits])
                    given.update(sources.counts(row, digits))
                    proven, need = gappa(
                        what, given, digits, options["-k"], lambda line:
                        sources.sizes(row, digits, re.sub(r"\s+", " ", line)))
                    sound = sound and proven
                    for letter, ends in need.items():
                        sense = known.get(letter, (0, 1))[1]
                        found.setdefault(letter, {})[digits] = ends[sense > 0]
            elif kind == "lemma":
                sound, found = lemma(what)
            elif kind == "free":  # no correctness rests on it
                print("%-22s %s" % (name, "no bound: " + check[5:]))
            elif kind == "use":
                if what not in names:
                    fail("%s: no row %s" % (name, what))
                print("%-22s %s" % (name, "as in row " + what))
            elif kind == "search":
                sound, ratio = search(options["-w"], what)
                seen.append(ratio if sound else None)
            else:
                fail("%s: no check %s" % (name, kind))
            for letter, value in found.items():
                if sound and how and letter in known:
                    needs.setdefault(letter, []).append((value, how))
        for letter, (value, sense, words) in known.items():
            if sense == 0:
                continue
            # of several derivations each must hold, for each kind of double
            worst, shown, how = None, "?", []
            for need, kind in needs.get(letter, []):
                how.append(kind)
                for digits, most in need.items():
                    # (what needs nothing has no slack to tell of)
                    slack = value[digits] / most if most > 0 else 10 ** 9
                    slack = slack if sense > 0 else 1 / slack
                    if worst is None or slack < worst:
                        worst, shown = slack, "%.4g" % float(most)
            done = {digits for need, _ in needs.get(letter, [])
                    for digits in need}
            if done != set(FORMATS):
                verdict = "UNCHECKED"
                unchecked += 1
            else:
                verdict = ", ".join(dict.fromkeys(how))
                if None in seen:
                    verdict += "; not searched"
                elif seen:
                    verdict += "; seen: %.2g of the bound" % max(seen)
                if worst < 1:
                    verdict = "NOT ENOUGH: " + verdict
                    fail("%s: %s is %s, needed %s" %
                         (name, letter, words, shown))
            print("%-22s %-5s %12s %10s %9s  %s" %
                  (name, letter, words[:12], shown,
                   "?" if worst is None else "-" if worst > 10 ** 8 else
                   "%.3g" % float(worst), verdict))
    if not only:
        for place in sorted(set(sources.uncovered())):
            fail("no row: " + place)
    for words in wrong:
        print("wrong: " + words)
    print("bounds: %d constants unchecked, %d wrong" %
          (unchecked, len(wrong)))
    return 1 if wrong or unchecked else 0


sys.exit(main())
