#include "header.h"
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/file.h"
#include "base/text.h"
#include "schema.h"

/* Places in the header of an SQLite file (its file format, "The Database Header"). */
enum { HEAD = 100, PAGE_SIZE = 16, PAGES = 28, CHANGES = 24, APPLICATION = 68, PAGES_OF = 92 };
static const char magic[16] = "SQLite format 3";

static uint32_t word(const unsigned char *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

/* What the header says; 0 where an old writer left it open. */
static long long stated_size(const unsigned char *head)
{
    uint32_t page = (uint32_t)head[PAGE_SIZE] << 8 | head[PAGE_SIZE + 1];
    page = page == 1 ? 65536 : page;
    return word(head + CHANGES) == word(head + PAGES_OF) ? (long long)word(head + PAGES) * page : 0;
}

bool aob_header_has_log(const char *path)
{
    struct aob_text log = {0};
    aob_text_add(&log, "%s-wal", path);
    bool has = aob_file_size(log.data) > 0;
    aob_text_finish(&log);
    return has;
}

static enum aob_header judge_head(const char *path, const unsigned char *head, long long size,
                                  struct aob_error *error)
{
    if (memcmp(head, magic, sizeof magic) != 0)
        return aob_fail(error, "%s: is not a history (no SQLite file): name another file", path);
    if (word(head + APPLICATION) != AOB_HISTORY_APPLICATION)
        return aob_fail(error, "%s: is the SQLite file of another program, no history: name another file",
                        path);
    if (size < stated_size(head) && !aob_header_has_log(path))
        return aob_fail(error, "%s: the history is cut short (%lld of %lld bytes): take its last copy", path,
                        size, stated_size(head));
    return AOB_HEADER_GOOD;
}

static enum aob_header judge_file(const char *path, int file, struct aob_error *error)
{
    unsigned char head[HEAD] = {0};
    struct stat info;
    if (fstat(file, &info) != 0)
        return aob_fail(error, "%s: cannot be read: %s", path, strerror(errno));
    if (!S_ISREG(info.st_mode))
        return aob_fail(error, "%s: is no file: name the file of a history", path);
    if (!info.st_size)
        return AOB_HEADER_EMPTY;
    if (pread(file, head, sizeof head, 0) < 0)
        return aob_fail(error, "%s: cannot be read: %s", path, strerror(errno));
    return judge_head(path, head, info.st_size, error);
}

enum aob_header aob_header_judge(const char *path, struct aob_error *error)
{
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0 && errno == ENOENT)
        return AOB_HEADER_NONE;
    if (file < 0)
        return aob_fail(error, "%s: cannot be opened: %s", path, strerror(errno));
    enum aob_header header = judge_file(path, file, error);
    close(file);
    return header;
}
