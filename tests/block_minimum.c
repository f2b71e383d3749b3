/* block_minimum FILE.exr SIZE SCALE: compares technique.AO, times SCALE, with the least Z of the block of SIZE x SIZE
 * pixels that each pixel lies in (at most SCALE). Prints the largest difference, as a share of that, and how many
 * blocks hold more than one depth, so that a copy of Z would show. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "store/image.h"

static float least_of_block(const float *depth, int width, int height, int size, int x, int y)
{
    float least = INFINITY;
    for (int v = y / size * size; v < y / size * size + size && v < height; v++)
        for (int u = x / size * size; u < x / size * size + size && u < width; u++)
            least = fminf(least, depth[v * width + u]);
    return least;
}

int main(int argc, char **argv)
{
    struct aob_image image;
    struct aob_error error = {{0}};
    if (argc != 4 || !aob_image_read(&image, argv[1], &error))
        return printf("usage: block_minimum FILE.exr SIZE SCALE; %s\n", error.text), 2;
    const float *depth = aob_image_channel(&image, "Z"), *shown = aob_image_channel(&image, "technique.AO");
    int size = atoi(argv[2]), varied = 0;
    double scale = atof(argv[3]), worst = 0;
    for (int y = 0; depth && shown && y < image.height; y++)
        for (int x = 0; x < image.width; x++) {
            double least = fmin(scale, least_of_block(depth, image.width, image.height, size, x, y));
            double value = scale * (double)shown[y * image.width + x];
            double off = fabs(value - least) / least;
            worst = isfinite(off) ? fmax(worst, off) : INFINITY;
            varied += x % size == 0 && y % size == 0 && (double)depth[y * image.width + x] > 1.001 * least;
        }
    printf("%.9f %d\n", worst, varied);
    aob_image_finish(&image);
    return depth && shown ? 0 : 2;
}
