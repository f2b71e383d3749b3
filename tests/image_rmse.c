/* image_rmse A.exr CHANNEL B.exr CHANNEL: the root of the mean squared difference over the pixels that are no sky (A's
 * channel Z is finite), on one line. For the tests in cli/, which hold the program's own scores to it. */
#include <math.h>
#include <stdio.h>
#include "store/image.h"

int main(int argc, char **argv)
{
    struct aob_image a, b;
    struct aob_error error = {{0}};
    if (argc != 5 || !aob_image_read(&a, argv[1], &error) || !aob_image_read(&b, argv[3], &error))
        return printf("usage: image_rmse A.exr CHANNEL B.exr CHANNEL; %s\n", error.text), 2;
    const float *x = aob_image_channel(&a, argv[2]), *y = aob_image_channel(&b, argv[4]),
                *z = aob_image_channel(&a, "Z");
    double sum = 0, count = 0;
    if (!x || !y || !z || a.width != b.width || a.height != b.height)
        return printf("a channel is missing, or the sizes differ\n"), 2;
    for (size_t i = 0; i < (size_t)a.width * (size_t)a.height; i++)
        if (isfinite(z[i])) {
            sum += ((double)x[i] - y[i]) * ((double)x[i] - y[i]);
            count++;
        }
    printf("%.12g\n", sqrt(sum / count));
    aob_image_finish(&a);
    aob_image_finish(&b);
    return 0;
}
