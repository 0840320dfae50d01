/* mutation.c - break a file in one place at a time, in C or, if its name ends
 * in .f, in FORTRAN 77; see mutation.sh.
 *
 *     mutation FILE        a line for each change: its number, the line in
 *                          FILE, and what it does
 *     mutation FILE K      FILE with change K
 *     mutation -draw M SEED
 *                          the numbers 1 ... M in an order of chance
 *
 * Changes: < to <= and back, > and >=, == and !=, + and -, * and /, && and
 * ||, & and |, their assigning forms, ++ and --; a sign left out; an integer
 * constant one more or less; a floating one doubled, halved or 0; a condition
 * of if, while or for negated; an operand of && or || dropped; a statement left
 * out, or a jump.  Not touched:
 * what the preprocessor reads, but for the values of macros, and the lengths
 * of declared arrays; in FORTRAN labels and all declarations but PARAMETER.
 * (Lines may be longer than 72 columns then.)
 */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LONGEST 500000
#define TOKENS 200000
#define CHANGES 40000

static char text[LONGEST + 1];
static long length;
static int fortran;

static struct token {
    long from, to;
    int line;
    int first; /* it begins the value of a macro, or a statement in FORTRAN */
} token[TOKENS + 1];
static int ntoken;

/* The text from ... to - 1 becomes before, what it was if kept, and after. */
static struct change {
    long from, to;
    int line, keep;
    char before[40], after[8];
    char what[80];
} change[CHANGES];
static int nchange;

static int is(int i, const char *s)
{
    long n = (long)strlen(s);

    return i >= 0 && i < ntoken && token[i].to - token[i].from == n &&
           strncmp(text + token[i].from, s, (size_t)n) == 0;
}

/* Is token i one of the words, which end with NULL? */
static int among(int i, const char *const *word)
{
    for (; *word != NULL; word++)
        if (is(i, *word)) return 1;
    return 0;
}

static int is_name(int i)
{
    int c = i >= 0 && i < ntoken ? text[token[i].from] : 0;

    return isalpha(c) || c == '_';
}

static int is_number(int i)
{
    const char *s;

    if (i < 0 || i >= ntoken) return 0;
    s = text + token[i].from;
    return isdigit((unsigned char)*s) ||
           (*s == '.' && isdigit((unsigned char)s[1]));
}

static int is_type(int i)
{
    static const char *const type[] = {
        "int", "double", "float", "long", "char", "short", "unsigned", "void",
        "const", "static", "volatile", "struct", "typedef", "tess_int",
        "tess_real", "hh_set", "candidate_list", "search", "mesher",
        "qr_factors", "ball_filter", "ref_surface", "cospherical_set", "whole",
        NULL
    };

    return among(i, type);
}

static void quoted(char *to, long from, long end, int most)
{
    int n = 0;

    for (; from < end && n < most; from++)
        if (!isspace((unsigned char)text[from]) ||
            (n > 0 && to[n - 1] != ' '))
            to[n++] = isspace((unsigned char)text[from]) ? ' ' : text[from];
    to[n] = '\0';
}

static void add(long from, long to, int line, int keep, const char *before,
                const char *after, const char *how)
{
    struct change *c = &change[nchange++];

    if (nchange == CHANGES) exit(2);
    c->from = from;
    c->to = to;
    c->line = line;
    c->keep = keep;
    strcpy(c->before, before);
    strcpy(c->after, after);
    quoted(c->what, from, to, 40);
    strcat(c->what, how);
    if (!keep) strcat(c->what, before);
}

static void replace(int i, const char *by)
{
    add(token[i].from, token[i].to, token[i].line, 0, by, "", " -> ");
}

/* Is what begins at i a line of comment in FORTRAN?  Else *first says whether it
 * begins a statement. */
static int comment(long i, int *first)
{
    if (text[i] == 'C' || text[i] == '\n') return 1;
    *first = text[i + 5] == ' ';
    return 0;
}

/* Cut the text into tokens: no comments, of the preprocessor's lines only the
 * values of macros; no labels. */
static void cut(void)
{
    static const char *const two[] = {
        "<=", ">=", "==", "!=", "&&", "||", "+=", "-=", "*=", "/=", "++",
        "--", "->", "<<", ">>", "|=", "&=", NULL
    };
    static const char *const power[] = { "**", NULL };
    const char *const *pair = fortran ? power : two;
    long i = 0, from;
    int line = 1, fresh = 1, first = 0, k;

    while (i < length) {
        char c = text[i];

        if (fortran && fresh) {
            fresh = 0;
            if (comment(i, &first))
                while (text[i] != '\n') i++;
            else
                i += 6;
            continue;
        }
        if (c == '\n') {
            line++;
            fresh = 1;
            i++;
            continue;
        }
        if (isspace((unsigned char)c) || c == '\\') {
            if (c == '\\' && text[i + 1] == '\n') {
                line++;
                i++;
            }
            i++;
            continue;
        }
        if (c == '/' && text[i + 1] == '*') {
            for (i += 2; text[i] != '*' || text[i + 1] != '/'; i++)
                line += text[i] == '\n';
            i += 2;
            continue;
        }
        if (c == '#' && fresh) {
            if (strncmp(text + i, "#define", 7) == 0) {
                for (i += 8; isalnum((unsigned char)text[i]) ||
                             text[i] == '_'; i++)
                    ;
                if (text[i] == '(') {
                    while (text[i] != ')') i++;
                    i++;
                }
                first = 1;
            } else
                while (text[i] != '\n') {
                    if (text[i] == '\\' && text[i + 1] == '\n') {
                        line++;
                        i++;
                    }
                    i++;
                }
            continue;
        }
        fresh = 0;
        from = i;
        if (isalpha((unsigned char)c) || c == '_')
            while (isalnum((unsigned char)text[i]) || text[i] == '_') i++;
        else if (isdigit((unsigned char)c) ||
                 (c == '.' && isdigit((unsigned char)text[i + 1])))
            while (isalnum((unsigned char)text[i]) || text[i] == '.' ||
                   ((text[i] == '-' || text[i] == '+') &&
                    strchr("eED", text[i - 1]) != NULL))
                i++;
        else if (fortran && c == '.')
            for (i++; text[i - 1] != '.' || i == from + 1; i++)
                ;
        else if (c == '"' || c == '\'') {
            for (i++; text[i] != c; i++) i += text[i] == '\\';
            i++;
        } else {
            i++;
            for (k = 0; pair[k] != NULL; k++)
                if (c == pair[k][0] && text[i] == pair[k][1]) {
                    i++;
                    break;
                }
        }
        if (ntoken == TOKENS) exit(2);
        token[ntoken].from = from;
        token[ntoken].to = i;
        token[ntoken].line = line;
        token[ntoken++].first = first;
        first = 0;
    }
}

/* The token that closes the bracket at i. */
static int closing(int i)
{
    int depth = 0;

    for (; i < ntoken; i++) {
        depth += is(i, "(") || is(i, "[") || is(i, "{");
        depth -= is(i, ")") || is(i, "]") || is(i, "}");
        if (depth == 0) break;
    }
    return i;
}

static void operators(int i)
{
    static const char *const swap[] = {
        "<", "<=", "<=", "<", ">", ">=", ">=", ">", "==", "!=", "!=", "==",
        "&&", "||", "||", "&&", "+=", "-=", "-=", "+=", "*=", "/=", "/=",
        "*=", "++", "--", "--", "++", "|", "&", ".LT.", ".LE.", ".LE.",
        ".LT.", ".GT.", ".GE.", ".GE.", ".GT.", ".EQ.", ".NE.", ".NE.",
        ".EQ.", ".AND.", ".OR.", ".OR.", ".AND.", NULL
    };
    /* after a name, a number or a bracket an operator has two operands */
    int k, binary = (is_name(i - 1) && !is_type(i - 1) &&
                     !is(i - 1, "return")) || is_number(i - 1) ||
                    is(i - 1, ")") || is(i - 1, "]");

    for (k = 0; swap[k] != NULL; k += 2)
        if (is(i, swap[k])) replace(i, swap[k + 1]);
    if (binary && !token[i].first) {
        if (is(i, "+")) replace(i, "-");
        if (is(i, "-")) replace(i, "+");
        if (is(i, "*")) replace(i, "/");
        if (is(i, "/")) replace(i, "*");
        if (is(i, "%")) replace(i, "/");
        if (is(i, "&")) replace(i, "|");
    } else if (is(i, "-"))
        replace(i, " ");
    if (is(i, "!") || is(i, ".NOT.")) replace(i, " ");
}

static void constant(int i)
{
    char s[40], by[60];
    const char *suffix = "";
    long n = token[i].to - token[i].from;

    if (n > 30) return;
    memcpy(s, text + token[i].from, (size_t)n);
    s[n] = '\0';
    if (strchr(s, '.') != NULL || strchr(s, 'e') != NULL) {
        if (fortran)
            suffix = strchr(s, 'D') != NULL ? "D0" : "E0";
        else if (s[n - 1] == 'f')
            suffix = "f";
        if (atof(s) == 0.0) {
            sprintf(by, "1.0%s", suffix);
            replace(i, by);
            return;
        }
        sprintf(by, "(2.0%s * %s)", suffix, s);
        replace(i, by);
        sprintf(by, "(0.5%s * %s)", suffix, s);
        replace(i, by);
        sprintf(by, "0.0%s", suffix);
        replace(i, by);
    } else {
        sprintf(by, "(%s + 1)", s);
        replace(i, by);
        sprintf(by, "(%s - 1)", s);
        replace(i, by);
    }
}

static void conditions(int i)
{
    int end, a, b;

    if (!is(i + 1, "(")) return;
    end = closing(i + 1);
    a = i + 2;
    b = end;
    if (fortran) {
        if (is(i, "IF"))
            add(token[a].from, token[b].from, token[i].line, 1, ".NOT.(", ")",
                " negated");
        return;
    }
    if (is(i, "for")) {
        while (a < end && !is(a, ";")) a++;
        for (b = ++a; b < end && !is(b, ";"); b++)
            if (is(b, "(")) b = closing(b);
    } else if (!is(i, "if") && !is(i, "while"))
        return;
    if (a < b)
        add(token[a].from, token[b].from, token[i].line, 1, "!(", ")",
            " negated");
}

/* Does an operand of && or || end before token i, or begin behind it? */
static int ends_operand(int i)
{
    static const char *const marks[] = {
        ";", "?", ":", ",", "=", "|=", "&=", "return", "&&", "||", "(", ")",
        "[", "]", "{", "}", NULL
    };

    return among(i, marks);
}

/* The operands of an && or || at token i, dropped: one after the other. */
static void operands(int i)
{
    int a = i - 1, b = i + 1, depth = 0;

    if (fortran || (!is(i, "&&") && !is(i, "||"))) return;
    /* (of `x || a && b' the left operand of && is a, the right one of || is
     * a && b; of `a && b || c' the left one of || is both) */
    for (;; a--) {
        depth += (is(a, ")") || is(a, "]")) - (is(a, "(") || is(a, "["));
        if (depth < 0 || (depth == 0 && !is(a, ")") && !is(a, "]") &&
                          !is(a, "(") && !is(a, "[") && ends_operand(a) &&
                          !(is(i, "||") && is(a, "&&"))))
            break;
    }
    for (depth = 0;; b++) {
        depth += (is(b, "(") || is(b, "[")) - (is(b, ")") || is(b, "]"));
        if (depth < 0 || (depth == 0 && !is(b, ")") && !is(b, "]") &&
                          !is(b, "(") && !is(b, "[") && ends_operand(b) &&
                          !(is(i, "||") && is(b, "&&"))))
            break;
    }
    add(token[a + 1].from, token[i].to, token[i].line, 0, "", "", " dropped");
    add(token[i].from, token[b - 1].to, token[i].line, 0, "", "", " dropped");
}

/* What begins at token i, where a statement may begin. */
static void statement(int i)
{
    static const char *const other[] = {
        "if", "while", "for", "do", "else", "switch", "case", "default",
        "goto", "{", "}", ";", NULL
    };
    int k = i;

    if (among(i, other) || is_type(i)) return;
    if (!is_name(i) && !is(i, "*") && !is(i, "++") && !is(i, "--")) return;
    for (; k < ntoken && !is(k, ";"); k++)
        if (is(k, "(")) k = closing(k);
    add(token[i].from, token[k].from, token[i].line, 0, "", "",
        " left out");
}

static void all(void)
{
    int i, k, depth = 0, start, declares = 0, parens = 0, last = -1;

    for (i = 0; i < ntoken; i++) {
        if (is(i, "{")) depth++;
        if (is(i, "}")) depth--;
        if (is(i, "(")) parens++;
        if (is(i, ")")) parens--;
        start = parens == 0 && (is(i - 1, "{") || is(i - 1, "}") ||
                                is(i - 1, ";") || is(i - 1, "else") ||
                                i - 1 == last || is(i - 1, "do"));
        if (start) declares = is_type(i);
        if (is(i, "if") || is(i, "while") || is(i, "for"))
            last = closing(i + 1);
        conditions(i);
        if (start && depth > 0 && !token[i].first) statement(i);
        /* the length of an array that is declared */
        if (is(i, "[") && parens == 0 && (declares || depth == 0) &&
            (is_type(i - 2) || is(i - 2, "*") || is(i - 2, ",") ||
             is(i - 1, "]"))) {
            k = closing(i);
            i = k;
            continue;
        }
        operators(i);
        operands(i);
        if (is_number(i)) constant(i);
    }
}

static void all_fortran(void)
{
    static const char *const declares[] = {
        "INTEGER", "REAL", "DOUBLE", "DATA", "EQUIVALENCE", "EXTERNAL",
        "SUBROUTINE", NULL
    };
    static const char *const other[] = {
        "PARAMETER", "IF", "ELSE", "END", "DO", "CONTINUE", "THEN", NULL
    };
    int i = 0, k, last = -1;

    while (i < ntoken) {
        for (k = i + 1; k < ntoken && !token[k].first; k++)
            ;
        if (token[i].first && among(i, declares)) {
            i = k;
            continue;
        }
        if ((token[i].first || i == last) && !among(i, other))
            add(token[i].from, token[k - 1].to, token[i].line, 0, "CONTINUE",
                "", " -> ");
        if (is(i, "IF") && is(i + 1, "(")) last = closing(i + 1) + 1;
        conditions(i);
        operators(i);
        if (is_number(i) && !is(i - 1, "TO") && !is(i - 1, "DO"))
            constant(i);
        i++;
    }
}

/* The numbers 1 ... m in an order of chance. */
static void draw(int m, unsigned long seed)
{
    int *number = (int *)malloc((size_t)(m + 1) * sizeof *number), i, j, t;

    if (number == NULL) exit(2);
    for (i = 0; i < m; i++) number[i] = i + 1;
    for (i = m - 1; i > 0; i--) {
        seed = (seed * 1103515245UL + 12345UL) & 0x7fffffffUL;
        j = (int)((seed >> 8) % (unsigned long)(i + 1));
        t = number[i];
        number[i] = number[j];
        number[j] = t;
    }
    for (i = 0; i < m; i++) printf("%d\n", number[i]);
    free(number);
}

int main(int argc, char **argv)
{
    FILE *in;
    const struct change *c;
    int i;

    if (argc > 3 && strcmp(argv[1], "-draw") == 0) {
        draw(atoi(argv[2]), (unsigned long)atol(argv[3]));
        return 0;
    }
    in = argc > 1 ? fopen(argv[1], "r") : NULL;
    if (in == NULL) {
        fprintf(stderr, "mutation FILE [K] or mutation -draw M SEED\n");
        return 2;
    }
    length = (long)fread(text, 1, LONGEST, in);
    fclose(in);
    fortran = strlen(argv[1]) > 2 &&
              strcmp(argv[1] + strlen(argv[1]) - 2, ".f") == 0;
    cut();
    if (fortran)
        all_fortran();
    else
        all();
    if (argc == 2) {
        for (i = 0; i < nchange; i++)
            printf("%d %d %s\n", i + 1, change[i].line, change[i].what);
        return 0;
    }
    i = atoi(argv[2]) - 1;
    if (i < 0 || i >= nchange) return 2;
    c = &change[i];
    fwrite(text, 1, (size_t)c->from, stdout);
    fputs(c->before, stdout);
    if (c->keep) fwrite(text + c->from, 1, (size_t)(c->to - c->from), stdout);
    fputs(c->after, stdout);
    fwrite(text + c->to, 1, (size_t)(length - c->to), stdout);
    return 0;
}
