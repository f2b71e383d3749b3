/* print_layers FILE.exr CHANNEL...: the values of the channels in the first pixel and in the middle one, a line each,
 * read without OpenEXR. For the tests in cli/. */
#include "exr_reader.h"

int main(int argc, char **argv)
{
    exr_need(argc > 2, "usage: print_layers FILE.exr CHANNEL...");
    struct exr_file file = exr_read(argv[1]);
    const int pixels[2] = {0, file.height / 2 * file.width + file.width / 2};
    for (int i = 0; i < 2; i++)
        for (int c = 2; c < argc; c++) {
            const float *channel = exr_channel(&file, argv[c]);
            exr_need(channel != NULL, argv[c]);
            printf("%g%s", (double)channel[pixels[i]], c + 1 < argc ? " " : "\n");
        }
    exr_free(&file);
    return 0;
}
