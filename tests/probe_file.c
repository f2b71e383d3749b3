/* probe_file OUT.exr WIDTH VALUE: a light probe of WIDTH x WIDTH / 2 texels of 1 in all channels, whose third texel is VALUE (nan
 * and inf allowed). For the tests in cli/. */
#include <stdio.h>
#include <stdlib.h>
#include "store/image.h"

int main(int argc, char **argv)
{
    static const char *const names[] = {"R", "G", "B"};
    struct aob_error error = {{0}};
    if (argc != 4)
        return printf("usage: probe_file OUT.exr WIDTH VALUE\n"), 2;
    struct aob_image image = {.width = atoi(argv[2]), .height = atoi(argv[2]) / 2};
    for (int c = 0; c < 3; c++) {
        float *channel = aob_image_add(&image, names[c]);
        for (int i = 0; i < image.width * image.height; i++)
            channel[i] = i == 2 ? strtof(argv[3], NULL) : 1;
    }
    bool ok = aob_image_write(&image, argv[1], &error);
    aob_image_finish(&image);
    return ok ? 0 : (printf("%s\n", error.text), 1);
}
