# roundings.py - what roundings and underflow do to a value, by running a
# routine's C code with other things in the place of numbers; bounds.py uses it.
#
# Counts of roundings: with polynomials.
#
# A number is a sum of terms, products of a routine's inputs.  As computed a
# term is the exact one times at most N factors 1 + d, |d| <= EPS.  N is counted
# for the most roundings that a compiler may make:
#   - a sum of k numbers: k - 1, whatever its order, for each of them
#   - a product: one more than its factors have together; none more if one is a
#     power of two
#   - a quotient: two more, as it may become a product with a reciprocal
#   - a square root: half of what its operand has, rounded up, and one
#   - a fused operation: no fewer, though it has one less
# A difference of inputs that is kept in a variable is an input itself, that has
# its roundings: errors are seen beside the differences.
#
# Sizes: with expressions for Gappa.  Of each operation's result one has the
# absolute value, at most U times the exact one for the operands' sizes, and T:
# U = 1 + EPS, and T is what underflow does, gradual or to 0.
#
# It knows declarations, assignments, `for' and `if' whose bounds and conditions
# are known numbers; an `if' on other conditions is left out; of a ? b : c and
# of the larger or lesser one of two numbers it makes an input that has the
# roundings of either, unless the condition is given.
import fractions
import re

TOKEN = re.compile(
    r"\s*(?:([0-9]+\.?[0-9]*(?:[eE][-+]?[0-9]+)?)[fFlLuU]*|([A-Za-z_]\w*)"
    r"|(->|<<|>>|<=|>=|==|!=|&&|\|\||\+\+|--|\+=|-=|\*=|/=|.))")
CASTS = {"double", "float", "tess_int", "int", "long", "whole"}
LEVELS = [["||"], ["&&"], ["|"], ["&"], ["==", "!="], ["<", ">", "<=", ">="],
          ["<<", ">>"], ["+", "-"], ["*", "/", "%"]]
SETS = ("=", "+=", "-=", "*=", "/=")


class Poly:
    """Operands of a sum, each a dict term -> (coefficient, roundings); a term
    is a sorted tuple of inputs."""

    def __init__(self, operands):
        self.operands = [o for o in operands if o]

    def settled(self):
        out = {}
        for operand in self.operands:
            for term, (factor, count) in operand.items():
                had = out.get(term, (0, 0))
                out[term] = (had[0] + factor,
                             max(had[1], count + len(self.operands) - 1))
        return out

    def most(self):
        return max([count for _, count in self.settled().values()] or [0])


def is_number(value):
    return isinstance(value, (int, fractions.Fraction))


def is_power(value):
    """1 if it is 0 or plus or minus a power of two"""
    value = abs(fractions.Fraction(value))
    return value == 0 or (value.numerator & (value.numerator - 1) == 0 and
                          value.denominator & (value.denominator - 1) == 0)


def atom(name, count=0):
    return Poly([{(name,): (fractions.Fraction(1), count)}])


def as_poly(value):
    if is_number(value):
        return Poly([{(): (fractions.Fraction(value), 0)} if value else {}])
    return value


def times(a, b):
    a, b = as_poly(a).settled(), as_poly(b).settled()
    alone = [list(x.values())[0][0] for x in (a, b) if list(x) == [()]]
    more = 0 if any(is_power(x) for x in alone) else 1
    out = {}
    for s, (f, n) in a.items():
        for t, (g, m) in b.items():
            term = tuple(sorted(s + t))
            had = out.get(term, (0, 0))
            out[term] = (had[0] + f * g, max(had[1], n + m + more))
    return Poly([out])


class Counts:
    """Polynomials, with roundings."""

    def atom(self, name):
        return atom(name)

    def negative(self, a):
        return times(-1, a)

    def add(self, a, b, sign):
        a, b = as_poly(a), as_poly(b)
        if sign < 0:
            b = Poly([{t: (-f, n) for t, (f, n) in o.items()}
                      for o in b.operands])
        return Poly(a.operands + b.operands)

    def times(self, a, b):
        return times(a, b)

    def over(self, a, b):
        if is_number(b):
            out = times(a, fractions.Fraction(1) / b)
            return out if is_power(b) else Poly([{
                t: (f, n + 1) for t, (f, n) in out.settled().items()}])
        return times(a, atom("1/(%s)" % self.words(b), b.most() + 1))

    def words(self, a):
        return " + ".join("*".join(t) for t in as_poly(a).settled())

    def fabs(self, a):
        terms = as_poly(a).settled()
        if len(terms) > 1 and any(f < 0 for f, _ in terms.values()):
            return atom("fabs(%s)" % self.words(a), a.most())
        return Poly([{t: (abs(f), n) for t, (f, n) in terms.items()}])

    def sqrt(self, a):
        return atom("sqrt(%s)" % self.words(a),
                    (as_poly(a).most() + 1) // 2 + 1)

    def either(self, word, a, b):
        return atom("%s(%s, %s)" % (word, self.words(a), self.words(b)),
                    max(as_poly(a).most(), as_poly(b).most()))

    def kept(self, name, value):
        """What a variable keeps: an input, if it is a difference of such, or
        one of two."""
        terms = value.settled()
        if not terms:
            return 0
        inputs = len(value.operands) > 1 and all(
            len(t) == 1 and n == len(value.operands) - 1
            for t, (_, n) in terms.items())
        choice = any(re.match(r"(\?|larger|lesser|fabs)\(", x)
                     for t in terms for x in t[:1]) and len(terms) == 1
        return atom(name, value.most()) if inputs or choice else value


class Sizes:
    """Sums of expressions for Gappa: lists of them."""

    def __init__(self, prefix, under, inputs):
        self.prefix = prefix
        self.under = under
        self.inputs = inputs  # [(pattern, expression)]
        self.lines = []

    def define(self, words):
        self.lines.append("%s_%d = %s;" % (self.prefix, len(self.lines), words))
        return ["%s_%d" % (self.prefix, len(self.lines) - 1)]

    def one(self, a):
        """The sum as one expression: each but one addition is rounded."""
        if is_number(a):
            a = fractions.Fraction(abs(a))
            return "(%d / %d)" % (a.numerator, a.denominator)
        if len(a) == 1:
            return a[0]
        u = " * ".join(["U"] * (len(a) - 1))
        a[:] = self.define("(%s) * %s + %d * U * %s" % (
            " + ".join(a), u, len(a), self.under))
        return a[0]

    def atom(self, name):
        for sort, words in self.inputs:
            if re.fullmatch(sort, name):
                return self.define(words)
        raise SyntaxError("no size of " + name)

    def negative(self, a):
        return a

    def add(self, a, b, sign):
        return [x for c in (a, b)
                for x in ([self.one(c)] if is_number(c) and c else c or [])]

    def times(self, a, b):
        more = "" if any(is_number(x) and is_power(x) for x in (a, b)) \
            else " * U"
        return self.define("%s * %s%s + %s" % (
            self.one(a), self.one(b), more, self.under))

    def over(self, a, b):
        if not is_number(b):
            raise SyntaxError("size of a quotient")
        return self.times(a, fractions.Fraction(1) / b)

    def fabs(self, a):
        return [self.one(a)]

    def sqrt(self, a):
        raise SyntaxError("size of a root")

    def either(self, word, a, b):
        return self.define("%s + %s" % (self.one(a), self.one(b)))

    def kept(self, name, value):
        return [self.one(value)]


class Machine:
    def __init__(self, text, macros, given, atoms, algebra):
        """text is a routine's body, macros what #define says, given is what
        conditions are, by their text, and names that are numbers; atoms are
        variables that count as inputs."""
        self.macros = macros
        self.given = given
        self.atoms = atoms
        self.algebra = algebra
        self.env = {}
        self.tokens = self.lex(text)
        self.at = 0

    def lex(self, text):
        out = []
        for number, name, sign in TOKEN.findall(text):
            if name in self.macros and not isinstance(self.macros[name], tuple):
                out += self.lex(self.macros[name])
            elif number or name or sign.strip():
                out.append(number or name or sign)
        # macros with arguments
        i = 0
        while i < len(out):
            macro = self.macros.get(out[i])
            if isinstance(macro, tuple) and out[i + 1:i + 2] == ["("]:
                depth, k, args = 1, i + 2, [[]]
                while depth:
                    depth += (out[k] in "([") - (out[k] in ")]")
                    if out[k] == "," and depth == 1:
                        args.append([])
                    elif depth:
                        args[-1].append(out[k])
                    k += 1
                body = []
                for word in self.lex(macro[1]):
                    body += args[macro[0].index(word)] \
                        if word in macro[0] else [word]
                out[i:k] = body
            else:
                i += 1
        return out

    # ---- the parser: trees ----
    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, word=None):
        token = self.peek()
        if word is not None and token != word:
            raise SyntaxError("%s, not %s, at %s" % (
                token, word, " ".join(self.tokens[self.at - 9:self.at + 9])))
        self.at += 1
        return token

    def expression(self):
        tree = self.ternary()
        while self.peek() in SETS:
            tree = ("set", self.take(), tree, self.expression())
        return tree

    def ternary(self):
        start = self.at
        tree = self.binary(0)
        if self.peek() == "?":
            words = "".join(self.tokens[start:self.at])
            self.take()
            yes = self.expression()
            self.take(":")
            return ("?", words, tree, yes, self.ternary())
        return tree

    def binary(self, level):
        if level == len(LEVELS):
            return self.unary()
        tree = self.binary(level + 1)
        while self.peek() in LEVELS[level]:
            tree = ("op", self.take(), tree, self.binary(level + 1))
        return tree

    def unary(self):
        token = self.peek()
        if token in ("-", "+", "!", "*", "&", "++", "--"):
            self.take()
            return ("unary", token, self.unary())
        if token == "(" and self.tokens[self.at + 1] in CASTS and \
                self.tokens[self.at + 2] == ")":
            self.at += 3
            return self.unary()
        return self.postfix()

    def postfix(self):
        token = self.take()
        if token == "(":
            tree = self.expression()
            self.take(")")
        elif re.match(r"[0-9]", token):
            tree = ("number", fractions.Fraction(token))
        else:
            tree = ("name", token)
        while True:
            token = self.peek()
            if token == "[":
                self.take()
                tree = ("index", tree, self.expression())
                self.take("]")
            elif token == "->" or token == ".":
                self.take()
                tree = ("name", tree[1] + "." + self.take()) \
                    if tree[0] == "name" else ("field", tree, self.take())
            elif token == "(":
                self.take()
                args = []
                while self.peek() != ")":
                    args.append(self.expression())
                    if self.peek() == ",":
                        self.take()
                self.take(")")
                tree = ("call", tree[1], args)
            elif token in ("++", "--"):
                self.take()
                tree = ("set", "+=" if token == "++" else "-=", tree,
                        ("number", fractions.Fraction(1)))
            else:
                return tree

    def statement(self):
        token = self.peek()
        if token == "{":
            self.take()
            body = []
            while self.peek() != "}":
                body.append(self.statement())
            self.take()
            return ("block", body)
        if token == "for":
            self.take()
            self.take("(")
            head = []
            for end in (";", ";", ")"):
                part = []
                while self.peek() != end:
                    part.append(self.expression())
                    if self.peek() == ",":
                        self.take()
                self.take(end)
                head.append(part)
            return ("for", head, self.statement())
        if token == "if":
            self.take()
            self.take("(")
            start = self.at
            test = self.expression()
            words = "".join(self.tokens[start:self.at])
            self.take(")")
            yes, no = self.statement(), ("block", [])
            if self.peek() == "else":
                self.take()
                no = self.statement()
            return ("if", words, test, yes, no)
        if token == "return":
            self.take()
            tree = ("name", "") if self.peek() == ";" else self.expression()
            self.take(";")
            return ("return", tree)
        if token in ("continue", "break"):
            self.take()
            self.take(";")
            return (token,)
        if token == "while":
            self.take()
            self.take("(")
            self.expression()
            self.take(")")
            return ("if", "", ("name", "while"), self.statement(),
                    ("block", []))
        if token in ("do", "switch"):
            raise SyntaxError("no " + token)
        # a declaration: a type, or two names in a row
        declared = False
        while re.match(r"[A-Za-z_]", self.peek()) and (
                self.peek() in ("const", "static", "volatile", "struct") or
                re.match(r"[A-Za-z_*]", self.tokens[self.at + 1])):
            self.take()
            declared = True
        parts = []
        while self.peek() != ";":
            while declared and self.peek() == "*":
                self.take()
            left = self.postfix() if declared else self.expression()
            if declared and self.peek() == "=":
                self.take()
                if self.peek() == "{":  # a list of values
                    place = 0
                    while self.peek() != ";" and self.peek() != "":
                        if re.match(r"[0-9]", self.peek()):
                            parts.append(("set", "=", (
                                "index", left[1], ("number", place)),
                                          self.unary()))
                            place += 1
                        elif self.take() == "}" and self.peek() != "}" and \
                                self.peek() != ",":
                            break
                else:
                    parts.append(("set", "=", left, self.ternary()))
            elif not declared:
                parts.append(left)
            if self.peek() == ",":
                self.take()
        self.take(";")
        return ("block", [("expression", part) for part in parts])

    # ---- running ----
    def name(self, tree):
        """the name of a place"""
        if tree[0] == "name":
            return tree[1]
        if tree[0] == "index":
            base, at = tree[1], self.value(tree[2])
            while base[0] == "op" and base[1] == "+":
                more = self.value(base[3])
                if not is_number(more) or not is_number(at):
                    break
                base, at = base[2], at + more
            at = str(at) if is_number(at) else self.words(tree[2])
            return "%s[%s]" % (self.name(base), at)
        if tree[0] == "unary" and tree[1] in "*&":
            return tree[1] + self.name(tree[2])
        return self.words(tree)

    def words(self, tree):
        if tree[0] == "number":
            return str(tree[1])
        return "(" + " ".join(self.words(t) if isinstance(t, tuple) else str(t)
                              for t in tree) + ")"

    def value(self, tree):
        kind = tree[0]
        if kind == "number":
            return tree[1]
        if kind in ("name", "index", "field") or \
                kind == "unary" and tree[1] == "*":
            name = self.name(tree)
            if name in self.given:
                return self.given[name]
            if name not in self.env:
                self.env[name] = self.algebra.atom(name)
            return self.env[name]
        if kind == "set":
            return self.assign(tree)
        if kind == "unary":
            value = self.value(tree[2])
            if tree[1] == "-":
                return -value if is_number(value) else \
                    self.algebra.negative(value)
            if tree[1] == "!" and is_number(value):
                return int(not value)
            return value
        if kind == "op":
            return self.combine(tree[1], self.value(tree[2]),
                                self.value(tree[3]))
        if kind == "?":
            test = self.given.get(tree[1])
            if test is None:
                test = self.value(tree[2])
            if is_number(test):
                return self.value(tree[3] if test else tree[4])
            return self.algebra.either("?", self.value(tree[3]),
                                       self.value(tree[4]))
        if kind == "call":
            return self.call(tree[1], tree[2])
        raise SyntaxError(str(tree))

    def combine(self, sign, a, b):
        if is_number(a) and is_number(b):
            return {"+": lambda: a + b, "-": lambda: a - b,
                    "*": lambda: a * b, "%": lambda: a % b,
                    "/": lambda: a // b if isinstance(a, int) and
                    isinstance(b, int) else fractions.Fraction(a) / b,
                    "<": lambda: int(a < b), ">": lambda: int(a > b),
                    "<=": lambda: int(a <= b), ">=": lambda: int(a >= b),
                    "==": lambda: int(a == b), "!=": lambda: int(a != b),
                    "&&": lambda: int(bool(a and b)),
                    "||": lambda: int(bool(a or b)),
                    "&": lambda: int(a) & int(b),
                    "<<": lambda: a * 2 ** int(b)}[sign]()
        if sign == "+" or sign == "-":
            return self.algebra.add(a, b, 1 if sign == "+" else -1)
        if sign == "*":
            return self.algebra.times(a, b)
        if sign == "/":
            return self.algebra.over(a, b)
        return self.algebra.atom("(%s)" % sign)

    def call(self, name, args):
        if name == "fabs":
            return self.algebra.fabs(self.value(args[0]))
        if name == "sqrt":
            return self.algebra.sqrt(self.value(args[0]))
        if name in ("larger", "lesser"):
            return self.algebra.either(name, *[self.value(x) for x in args])
        if name == "dot" or name == "norm1":
            out = 0
            for k in range(3):
                a = [self.value(("index", x, ("number", k))) for x in args]
                part = self.algebra.times(a[0], a[1]) if name == "dot" else \
                    self.algebra.fabs(a[0])
                out = self.algebra.add(out, part, 1)
            return out
        if name == "minus":
            for k in range(3):
                at = ("number", k)
                self.assign(("set", "=", ("index", args[2], at),
                             ("op", "-", ("index", args[0], at),
                              ("index", args[1], at))))
            return 0
        return self.algebra.atom(name + "()")

    def assign(self, tree):
        _, sign, left, right = tree
        name = self.name(left)
        if name in self.atoms and sign == "=":
            self.env[name] = self.algebra.atom(name)
            return self.env[name]
        value = self.value(right)
        if sign != "=":
            value = self.combine(sign[0], self.value(left), value)
        elif not is_number(value):
            value = self.algebra.kept(name, value)
        self.env[name] = value
        return value

    def run(self, tree):
        kind = tree[0]
        if kind == "block":
            for part in tree[1]:
                if self.run(part):
                    return True
        elif kind == "expression":
            try:
                self.value(tree[1])
            except SyntaxError:  # of what has no size: nor has the result
                if tree[1][0] == "set":
                    self.env.pop(self.name(tree[1][2]), None)
        elif kind == "return":
            try:
                self.env["return"] = self.value(tree[1])
            except SyntaxError:
                pass  # of what has no size
        elif kind == "for":
            for part in tree[1][0]:
                self.value(part)
            for _ in range(1000):
                test = [self.value(part) for part in tree[1][1]][-1]
                if not is_number(test):
                    raise SyntaxError("for: " + str(tree[1][1]))
                if not test:
                    break
                self.run(tree[2])
                for part in tree[1][2]:
                    self.value(part)
        elif kind in ("break", "continue"):
            raise SyntaxError(kind)
        elif kind == "if":
            test = self.given.get(tree[1])
            if test is None:
                try:
                    test = self.value(tree[2])
                except SyntaxError:
                    return False
            if is_number(test):
                self.run(tree[3] if test else tree[4])
        return False


def macros_of(text):
    """Object-like macros that are numbers, and those with arguments.  (What
    stands for a chapter that is left out does not count.)"""
    out = {}
    text = re.sub(r"(#ifndef TESS_(?:NO_\w+|CORE)\n(?:(?!#if).)*?)#else\n"
                  r"(?:(?!#if).)*?#endif", r"\1#endif", text, flags=re.S)
    for name, args, body in re.findall(
            r"#define (\w+)(\([^)]*\))? ([^\n]*)", text):
        if args and "&&" not in body and "?" not in body:
            out[name] = (re.findall(r"\w+", args), body.strip())
        elif re.fullmatch(r"[0-9]+", body.strip()):
            out[name] = body.strip()
    return out


def count(body, macros, given, atoms, asked):
    """The most roundings of the terms of the value asked for: its name, or
    `NAME of INPUT...': of the terms that have all these inputs, each as often
    as it stands there.  An input may be a pattern."""
    name, _, with_ = asked.partition(" of ")
    machine = Machine(body, macros, given, atoms, Counts())
    machine.run(machine.statement())
    value = machine.env.get(name.strip())
    if value is None:
        raise SyntaxError("no value " + name)
    counts = []
    for term, (factor, number) in as_poly(value).settled().items():
        left = list(term)
        for want in with_.split():
            found = [x for x in left if re.fullmatch(want, x)]
            if not found:
                break
            left.remove(found[0])
        else:
            if factor:
                counts.append(number)
    if not counts:
        raise SyntaxError("no such terms: " + asked)
    return max(counts), as_poly(value).settled()


def sizes(prefix, body, macros, given, atoms, name, under, inputs):
    """Definitions for Gappa, the last one of the size of the value NAME, with
    the name PREFIX."""
    algebra = Sizes(prefix, under, inputs)
    machine = Machine(body, macros, given, atoms, algebra)
    machine.run(machine.statement())
    if name not in machine.env:
        raise SyntaxError("no value " + name)
    words = algebra.one(machine.env[name])
    return "\n".join(algebra.lines + ["%s = %s;" % (prefix, words)])
