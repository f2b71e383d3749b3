#include "flags.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "memory.h"

static const struct aob_flag *find(const struct aob_flag *table, const char *name, size_t size)
{
    for (const struct aob_flag *flag = table; flag->name; flag++)
        if (strlen(flag->name) == size && strncmp(flag->name, name, size) == 0)
            return flag;
    return NULL;
}

static bool set(const char *command, const struct aob_flag *flag, const char *value, void *options,
                struct aob_error *error)
{
    void *field = (char *)options + flag->offset;
    if (flag->kind == AOB_FLAG_MANY) {
        struct aob_words *words = field;
        *AOB_PUSH(words->items, words->count, words->capacity) = value;
        return true;
    }
    const char **text = field;
    if (*text)
        return aob_fail(error, "%s: --%s is given twice", command, flag->name);
    *text = value;
    return true;
}

/* The word at *at, which begins with a dash, and the word behind it where that is its value: *at moves on then. */
static bool take(const struct aob_flags_desc *desc, int *at, void *options, struct aob_error *error)
{
    const char *word = desc->argv[*at], *name = word + (word[1] == '-' ? 2 : 1), *command = desc->command;
    const char *equals = word[1] == '-' ? strchr(name, '=') : NULL;
    const struct aob_flag *flag = find(desc->table, name, equals ? (size_t)(equals - name) : strlen(name));
    if (!flag || (strlen(flag->name) == 1) != (word[1] != '-'))
        return aob_fail(error, "%s: unknown flag %s; --help names the flags", command, word);
    if (flag->kind == AOB_FLAG_SWITCH) {
        *(bool *)((char *)options + flag->offset) = true;
        return !equals || aob_fail(error, "%s: --%s takes no value", command, flag->name);
    }
    if (equals)
        return set(command, flag, equals + 1, options, error);
    if (*at + 1 == desc->argc)
        return aob_fail(error, "%s: %s needs a value: %s", command, word, flag->value);
    return set(command, flag, desc->argv[++*at], options, error);
}

bool aob_flags_parse(const struct aob_flags_desc *desc, void *options, struct aob_words *words,
                     struct aob_error *error)
{
    for (int i = 0; i < desc->argc; i++) {
        const char *word = desc->argv[i];
        if (word[0] != '-' || !word[1])
            *AOB_PUSH(words->items, words->count, words->capacity) = word;
        else if (!take(desc, &i, options, error))
            return false;
    }
    return true;
}

void aob_flags_help(const struct aob_flag *table, struct aob_text *out)
{
    for (const struct aob_flag *flag = table; flag->name; flag++) {
        char left[64];
        snprintf(left, sizeof left, "%s%s %s", strlen(flag->name) == 1 ? "-" : "--", flag->name,
                 flag->value ? flag->value : "");
        aob_text_add_line(out, "  %-24s %s", left, flag->help);
    }
}

void aob_words_finish(struct aob_words *words)
{
    free(words->items);
    *words = (struct aob_words){0};
}
