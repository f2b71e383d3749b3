/* image_moments FILE.exr CHANNEL: mean, mean square, and the means of value times column and value times row (each
 * coordinate over the image's width or height), on one line. An image that changed, or moved, changes one of them. */
#include <stdio.h>
#include "store/image.h"

int main(int argc, char **argv)
{
    struct aob_image image;
    struct aob_error error = {{0}};
    if (argc != 3 || !aob_image_read(&image, argv[1], &error))
        return printf("usage: image_moments FILE.exr CHANNEL; %s\n", error.text), 2;
    const float *pixels = aob_image_channel(&image, argv[2]);
    double moments[4] = {0}, count = (double)image.width * image.height;
    for (int y = 0; pixels && y < image.height; y++)
        for (int x = 0; x < image.width; x++) {
            double v = pixels[(size_t)y * (size_t)image.width + (size_t)x];
            double terms[4] = {v, v * v, v * (x + 0.5) / image.width, v * (y + 0.5) / image.height};
            for (int m = 0; m < 4; m++)
                moments[m] += terms[m] / count;
        }
    printf("%.9f %.9f %.9f %.9f\n", moments[0], moments[1], moments[2], moments[3]);
    aob_image_finish(&image);
    return pixels ? 0 : 2;
}
