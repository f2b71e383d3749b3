#include "measure_turn.h"
#include <errno.h>
#include <fcntl.h>
#include <unistd.h>

/* A lock in the stretch that another one has (`length` 0: to the end of all files). Locks are those of an open file, as a
 * process' own would go whenever it closes the file anywhere. */
static bool find(int file, off_t from, off_t length, struct flock *found)
{
    *found = (struct flock){.l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = from, .l_len = length};
    return fcntl(file, F_OFD_GETLK, found) == 0 && found->l_type != F_UNLCK;
}

static bool set(const struct aob_measure_turn *turn, short type)
{
    const struct flock place = {.l_type = type, .l_whence = SEEK_SET, .l_start = turn->place, .l_len = 1};
    return fcntl(turn->file, F_OFD_SETLK, &place) == 0;
}

/* Behind all that are taken; -1 if somebody has taken all that there are. */
static off_t find_end(int file)
{
    struct flock taken;
    off_t end = 0;
    while (find(file, end, 0, &taken)) {
        if (taken.l_len == 0)
            return -1;
        end = taken.l_start + taken.l_len;
    }
    return end;
}

void aob_measure_turn_join(struct aob_measure_turn *turn, int file)
{
    *turn = (struct aob_measure_turn){.file = file, .place = find_end(file)};
    while (turn->place >= 0 && !set(turn, F_WRLCK)) {
        bool faster = errno == EAGAIN || errno == EACCES; /* somebody else was */
        turn->place = faster ? find_end(file) : -1;
    }
}

bool aob_measure_turn_is_behind(const struct aob_measure_turn *turn)
{
    struct flock before;
    return turn->place > 0 && find(turn->file, 0, turn->place, &before);
}

void aob_measure_turn_leave(struct aob_measure_turn *turn)
{
    if (turn->place >= 0)
        set(turn, F_UNLCK); /* a child that was just started may still have the file */
    if (turn->file >= 0)
        close(turn->file);
    *turn = (struct aob_measure_turn){-1, -1};
}
