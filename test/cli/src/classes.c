/* classes.c - values that are words: each is a number, and the word is in a
 * table of the column's.
 */
#include <stdlib.h>
#include <string.h>

#include "driver.h"

/* classes - of a column: the words, one behind the other in text, each with a
 * '\0', from at on; and for words to be found 1 + their numbers in slots, which
 * are a power of two, at least twice as many. */
struct classes {
    char *text;
    size_t *at, used, room, many, slots, *slot;
};

classes *new_classes(void)
{
    classes *c = (classes *)space(1.0, sizeof *c);

    memset(c, 0, sizeof *c);
    return c;
}

/* slot_of - where the word's number is, or is to be. */
static size_t slot_of(const classes *c, const char *word, size_t length)
{
    unsigned long sum = 2166136261UL;
    size_t i, at;
    const char *s;

    for (i = 0; i < length; i++)
        sum = ((sum ^ (unsigned char)word[i]) * 16777619UL) & 0xffffffffUL;
    for (at = (size_t)sum & (c->slots - 1); c->slot[at] > 0;
         at = (at + 1) & (c->slots - 1)) {
        s = c->text + c->at[c->slot[at] - 1];
        if (strlen(s) == length && memcmp(s, word, length) == 0) break;
    }
    return at;
}

/* grow - twice as many slots. */
static void grow(classes *c)
{
    size_t k;
    const char *s;

    c->slots = c->slots > 0 ? 2 * c->slots : 16;
    free(c->slot);
    c->slot = (size_t *)space((double)c->slots, sizeof *c->slot);
    c->at = (size_t *)more_space(c->at, (double)c->slots, sizeof *c->at);
    memset(c->slot, 0, c->slots * sizeof *c->slot);
    for (k = 0; k < c->many; k++) {
        s = c->text + c->at[k];
        c->slot[slot_of(c, s, strlen(s))] = k + 1;
    }
}

double class_number(classes *c, const char *word, size_t length)
{
    size_t at;

    if (2 * (c->many + 1) > c->slots) grow(c);
    at = slot_of(c, word, length);
    if (c->slot[at] > 0) return (double)(c->slot[at] - 1);
    if (c->used + length >= c->room) {
        c->room = 2 * (c->room + length) + 1;
        c->text = (char *)more_space(c->text, (double)c->room, 1);
    }
    memcpy(c->text + c->used, word, length);
    c->text[c->used + length] = '\0';
    c->at[c->many++] = c->used;
    c->slot[at] = c->many;
    c->used += length + 1;
    return (double)(c->many - 1);
}

const char *class_name(const classes *c, double number)
{
    if (!(number >= 0.0 && number < (double)c->many)) return "";
    return c->text + c->at[(size_t)number];
}

long class_count(const classes *c)
{
    return (long)c->many;
}
