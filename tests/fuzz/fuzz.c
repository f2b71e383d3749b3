#include "fuzz.h"
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/file.h"
#include "base/hash.h"
#include "base/memory.h"
#include "base/sealed.h"
#include "base/text.h"

static char *folder;  /* NULL: not made yet */
static size_t loaded; /* answers that were no refusal */

static void remove_folder(void)
{
    static const char *const names[] = {"input", "device.yaml", "again"};
    for (size_t i = 0; folder && i < AOB_COUNT(names); i++) {
        char *path = fuzz_path(names[i]);
        unlink(path);
        free(path);
    }
    if (folder)
        rmdir(folder);
    free(folder);
    folder = NULL;
}

/* In memory where that is to be had, because what is written again is flushed to the disk each time. */
static void make_folder(void)
{
    const char *place = getenv("TMPDIR");
    struct aob_text text = {0};
    if (!place)
        place = access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp";
    aob_text_add(&text, "%s/aobudget-fuzz-XXXXXX", place);
    fuzz_require(mkdtemp(text.data) != NULL, "a folder can be made");
    folder = text.data;
    atexit(remove_folder);
}

char *fuzz_path(const char *name)
{
    if (!folder)
        make_folder();
    return aob_path_join(folder, name);
}

static char *write_file(const char *name, const void *bytes, size_t size, const char *end)
{
    char *path = fuzz_path(name);
    FILE *file = fopen(path, "wb");
    bool ok = file && fwrite(bytes, 1, size, file) == size && fputs(end, file) >= 0;
    fuzz_require(file && fclose(file) == 0 && ok, "the input can be written");
    return path;
}

char *fuzz_file(const char *name, const void *bytes, size_t size)
{
    return write_file(name, bytes, size, "");
}

/* A seal as sealed.h describes it, by hand: the mark, and the digest of bytes and name. */
char *fuzz_sealed_file(const char *name, const void *bytes, size_t size)
{
    char seal[AOB_SEAL_SIZE + 1];
    struct aob_hash hash;
    aob_hash_begin(&hash);
    aob_hash_add(&hash, bytes, size);
    aob_hash_add(&hash, name, strlen(name));
    strcpy(seal, aob_sealed_version);
    aob_hash_end(&hash, seal + strlen(seal));
    return write_file(name, bytes, size, seal);
}

void fuzz_require(bool kept, const char *rule)
{
    if (kept)
        return;
    fprintf(stderr, "FAILED: %s\n", rule);
    remove_folder();
    abort();
}

/* Two bytes U+0080..U+009F, three bytes U+202A..U+202E and U+2066..U+2069: they command a terminal, as those below a
 * blank do. */
static bool may_be_shown(const char *text)
{
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        bool control = *c < ' ' || *c == 0x7f || (*c == 0xc2 && c[1] >= 0x80 && c[1] <= 0x9f);
        bool turn = *c == 0xe2 && ((c[1] == 0x80 && c[2] >= 0xaa && c[2] <= 0xae) ||
                                   (c[1] == 0x81 && c[2] >= 0xa6 && c[2] <= 0xa9));
        if (control || turn)
            return false;
    }
    return true;
}

void fuzz_require_line(const struct aob_error *error, const char *path)
{
    json_t *text = json_string(error->text); /* NULL unless UTF-8 */
    bool ok = *error->text && may_be_shown(error->text) && text && strstr(error->text, path);
    if (!ok)
        fprintf(stderr, "the line is '%s'\n", error->text);
    fuzz_require(ok, "a refusal is one line that may be shown and names the file");
    json_decref(text);
}

bool fuzz_answer(bool ok, const struct aob_error *error, const char *path)
{
    loaded += ok;
    if (!ok)
        fuzz_require_line(error, path);
    return ok;
}

size_t fuzz_count_loaded(void)
{
    return loaded;
}
