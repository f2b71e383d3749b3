/* open_tiles A.exr CHANNEL: the share of the surfaces (channel Z is finite) that lie in tiles of 8 x 8 pixels whose surfaces are all
 * within 1/255 of 1, on one line: what an oracle would leave out by such tiles. For `./dev bench thrift`. */
#include <math.h>
#include <stdio.h>
#include "store/image.h"

enum { TILE = 8 };

/* Counts the surfaces of a tile; *open is whether all of them are. */
static int surfaces_of(const struct aob_image *image, const float *v, const float *z, int left, int top,
                       bool *open)
{
    int count = 0;
    *open = true;
    for (int y = top; y < top + TILE && y < image->height; y++)
        for (int x = left; x < left + TILE && x < image->width; x++) {
            size_t i = (size_t)y * (size_t)image->width + (size_t)x;
            if (!isfinite(z[i]))
                continue;
            count++;
            *open = *open && fabsf(v[i] - 1) <= 1 / 255.0f;
        }
    return count;
}

int main(int argc, char **argv)
{
    struct aob_image image;
    struct aob_error error = {{0}};
    int open_count = 0, count = 0;
    if (argc != 3 || !aob_image_read(&image, argv[1], &error))
        return printf("usage: open_tiles A.exr CHANNEL; %s\n", error.text), 2;
    const float *v = aob_image_channel(&image, argv[2]), *z = aob_image_channel(&image, "Z");
    if (!v || !z)
        return printf("a channel is missing\n"), 2;
    for (int top = 0; top < image.height; top += TILE)
        for (int left = 0; left < image.width; left += TILE) {
            bool open;
            int surfaces = surfaces_of(&image, v, z, left, top, &open);
            count += surfaces;
            open_count += open ? surfaces : 0;
        }
    printf("%.4f\n", count ? (double)open_count / count : NAN);
    aob_image_finish(&image);
    return 0;
}
