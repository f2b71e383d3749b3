/* compare_images A.exr B.exr CHANNEL...: exit code 0 if the channels are equal bit by bit. For the tests in cli/. */
#include <stdio.h>
#include <string.h>
#include "store/image.h"

int main(int argc, char **argv)
{
    struct aob_image a, b;
    struct aob_error error = {{0}};
    if (argc < 4 || !aob_image_read(&a, argv[1], &error) || !aob_image_read(&b, argv[2], &error)) {
        printf("usage: compare_images A.exr B.exr CHANNEL...; %s\n", error.text);
        return 2;
    }
    bool same = a.width == b.width && a.height == b.height;
    for (int c = 3; c < argc; c++) {
        const float *x = aob_image_channel(&a, argv[c]), *y = aob_image_channel(&b, argv[c]);
        bool equal = same && x && y && memcmp(x, y, (size_t)a.width * (size_t)a.height * sizeof *x) == 0;
        printf("%s: %s\n", argv[c], equal ? "equal" : "different");
        same = same && equal;
    }
    aob_image_finish(&a);
    aob_image_finish(&b);
    return !same;
}
