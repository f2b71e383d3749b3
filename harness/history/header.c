#include "header.h"
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "schema.h"

/* Places in the header of an SQLite file (its file format, "The Database Header"). */
enum { HEAD = 100, PAGE_SIZE = 16, PAGES = 28, CHANGES = 24, APPLICATION = 68, PAGES_OF = 92 };
/* And in its log, of the header and of each frame. */
enum {
    LOG_HEAD = 32,
    LOG_PAGE_SIZE = 8,
    LOG_SALT = 16,
    FRAME_HEAD = 24,
    FRAME_PAGES = 4,
    FRAME_SALT = 8,
    SALT = 8
};
static const char magic[16] = "SQLite format 3";

static uint32_t word(const unsigned char *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

static uint32_t page_size(const unsigned char *head)
{
    uint32_t page = (uint32_t)head[PAGE_SIZE] << 8 | head[PAGE_SIZE + 1];
    return page == 1 ? 65536 : page;
}

/* What the header says; 0 where an old writer left it open. */
static long long stated_size(const unsigned char *head)
{
    return word(head + CHANGES) == word(head + PAGES_OF) ? (long long)word(head + PAGES) * page_size(head)
                                                         : 0;
}

static char *log_of(const char *path)
{
    struct aob_text log = {0};
    aob_text_add(&log, "%s-wal", path);
    return log.data;
}

bool aob_header_has_log(const char *path)
{
    char *log = log_of(path);
    bool has = aob_file_size(log) > 0;
    free(log);
    return has;
}

/* Goes through the frames of a log ("The WAL File") to its last whole change; those behind it do not count. */
static bool frames_hold(int log, uint32_t page, uint32_t first, uint32_t count)
{
    unsigned char head[LOG_HEAD], frame[FRAME_HEAD];
    uint32_t seen = 0, whole = 0;
    off_t size = lseek(log, 0, SEEK_END);
    if (pread(log, head, sizeof head, 0) != sizeof head || word(head + LOG_PAGE_SIZE) != page ||
        size / (off_t)page < (off_t)count)
        return false;
    bool *met = AOB_NEW_ARRAY(bool, count);
    off_t step = FRAME_HEAD + (off_t)page;
    for (off_t at = LOG_HEAD; at + step <= size && pread(log, frame, sizeof frame, at) == sizeof frame &&
                              memcmp(frame + FRAME_SALT, head + LOG_SALT, SALT) == 0;
         at += step) {
        uint32_t place = word(frame) - first;
        if (place < count && !met[place]) {
            met[place] = true;
            seen++;
        }
        whole = word(frame + FRAME_PAGES) ? seen : whole;
    }
    free(met);
    return whole == count;
}

/* SQLite works a log into the file page by page, the header first. So a file whose end is not written yet is good, if the log
 * has every page of that end. */
static bool log_holds_end(const char *path, const unsigned char *head, long long size)
{
    uint32_t page = page_size(head), first = (uint32_t)(size / page) + 1;
    char *name = log_of(path);
    int log = open(name, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    bool holds = log >= 0 && frames_hold(log, page, first, word(head + PAGES) - first + 1);
    if (log >= 0)
        close(log);
    free(name);
    return holds;
}

static enum aob_header judge_head(const char *path, const unsigned char *head, long long size,
                                  struct aob_error *error)
{
    if (memcmp(head, magic, sizeof magic) != 0)
        return aob_fail(error, "%s: is not a history (no SQLite file): name another file", path);
    if (word(head + APPLICATION) != AOB_HISTORY_APPLICATION)
        return aob_fail(error, "%s: is the SQLite file of another program, no history: name another file",
                        path);
    if (size >= stated_size(head))
        return AOB_HEADER_GOOD;
    if (log_holds_end(path, head, size))
        return AOB_HEADER_SHORT;
    return aob_fail(error, "%s: the history is cut short (%lld of %lld bytes): take its last copy", path,
                    size, stated_size(head));
}

/* A writer may lengthen the file and drop its log between two looks at them: so what is refused is looked at again. */
static enum aob_header judge_file(const char *path, int file, struct aob_error *error)
{
    long long before = -1;
    for (;;) {
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
        enum aob_header header = judge_head(path, head, info.st_size, error);
        if (header != AOB_HEADER_BAD || info.st_size == before)
            return header;
        before = info.st_size;
    }
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
