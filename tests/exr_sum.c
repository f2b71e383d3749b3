/* exr_sum FILE.exr CHANNEL: the sum over all pixels, read without OpenEXR. For the tests in cli/. */
#include "exr_reader.h"

int main(int argc, char **argv)
{
    exr_need(argc == 3, "usage: exr_sum FILE.exr CHANNEL");
    struct exr_file file = exr_read(argv[1]);
    const float *channel = exr_channel(&file, argv[2]);
    double sum = 0;
    exr_need(channel != NULL, argv[2]);
    for (int i = 0; i < file.width * file.height; i++)
        sum += (double)channel[i];
    printf("%.9g\n", sum);
    exr_free(&file);
    return 0;
}
