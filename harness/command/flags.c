#include "flags.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

static const struct aob_flag *find(const struct aob_flags *flags, const char *name, size_t size)
{
    for (const struct aob_flag *flag = flags->flags; flag->name; flag++)
        if (strlen(flag->name) == size && strncmp(flag->name, name, size) == 0)
            return flag;
    return NULL;
}

static bool set(const struct aob_flags *flags, const struct aob_flag *flag, const char *value,
                struct aob_error *error)
{
    if (flag->many)
        *AOB_PUSH(flag->many->items, flag->many->count, flag->many->capacity) = value;
    else if (*flag->text)
        return aob_fail(error, "%s: --%s is given twice", flags->command, flag->name);
    else
        *flag->text = value;
    return true;
}

bool aob_flags_parse(const struct aob_flags *flags, int argc, char **argv, struct aob_words *words,
                     struct aob_error *error)
{
    for (int i = 0; i < argc; i++) {
        const char *word = argv[i];
        if (word[0] != '-' || !word[1]) {
            *AOB_PUSH(words->items, words->count, words->capacity) = word;
            continue;
        }
        const char *name = word + (word[1] == '-' ? 2 : 1),
                   *equals = word[1] == '-' ? strchr(name, '=') : NULL;
        const struct aob_flag *flag = find(flags, name, equals ? (size_t)(equals - name) : strlen(name));
        if (!flag || (strlen(flag->name) == 1) != (word[1] != '-'))
            return aob_fail(error, "%s: unknown flag %s; see: aobudget %s --help", flags->command, word,
                            flags->command);
        if (flag->on && equals)
            return aob_fail(error, "%s: --%s takes no value", flags->command, flag->name);
        if (flag->on)
            *flag->on = true;
        else if (!equals && i + 1 == argc)
            return aob_fail(error, "%s: %s needs a value: %s", flags->command, word, flag->value);
        else if (!set(flags, flag, equals ? equals + 1 : argv[++i], error))
            return false;
    }
    if (words->count < flags->least || words->count > flags->most)
        return aob_fail(error, "usage: aobudget %s %s", flags->command, flags->usage);
    return true;
}

void aob_flags_help(const struct aob_flags *flags)
{
    printf("usage: aobudget %s %s\n%s\n", flags->command, flags->usage, flags->summary);
    for (const struct aob_flag *flag = flags->flags; flag->name; flag++) {
        char left[64];
        snprintf(left, sizeof left, "%s%s %s", strlen(flag->name) == 1 ? "-" : "--", flag->name,
                 flag->value ? flag->value : "");
        printf("  %-24s %s\n", left, flag->help);
    }
}

void aob_words_finish(struct aob_words *words)
{
    free(words->items);
    *words = (struct aob_words){0};
}
