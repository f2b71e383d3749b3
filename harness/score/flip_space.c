#include "flip_space.h"
#include <math.h>

/* X, Y, Z relative to those of white; no sum of a colour that lacks a primary is rounded. */
static void relative_xyz(const double rgb[3], double xyz[3])
{
    static const double matrix[3][3] = {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                        {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                        {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};
    for (int i = 0; i < 3; i++)
        xyz[i] = (matrix[i][0] * rgb[0] + matrix[i][1] * rgb[1] + matrix[i][2] * rgb[2]) /
                 (matrix[i][0] + matrix[i][1] + matrix[i][2]);
}

/* The exact inverse of the above. */
static void rgb_of_relative_xyz(const double xyz[3], double rgb[3])
{
    static const double matrix[3][3] = {{1219569.0 / 395920, -608687.0 / 395920, -107481.0 / 197960},
                                        {-80960619.0 / 87888100, 82435961.0 / 43944050, 3976797.0 / 87888100},
                                        {93813.0 / 1774030, -180961.0 / 887015, 107481.0 / 93370}};
    for (int i = 0; i < 3; i++)
        rgb[i] = matrix[i][0] * xyz[0] + matrix[i][1] * xyz[1] + matrix[i][2] * xyz[2];
}

static double cut(double value)
{
    return fmin(fmax(value, 0), 1);
}

/* The curve of CIE L*a*b* is a cube root with a straight line near black. */
static double lab_curve(double t)
{
    const double delta = 6.0 / 29;
    return t > delta * delta * delta ? cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

static void hunt_lab(const double rgb[3], double lab[3])
{
    double f[3];
    relative_xyz(rgb, f);
    for (int i = 0; i < 3; i++)
        f[i] = lab_curve(f[i]);
    lab[0] = 116 * f[1] - 16;
    lab[1] = 0.01 * lab[0] * 500 * (f[0] - f[1]);
    lab[2] = 0.01 * lab[0] * 200 * (f[1] - f[2]);
}

void aob_flip_space_opponents(const double rgb[3], double opponents[AOB_FLIP_SPACE_OPPONENTS])
{
    const double shown[3] = {cut(rgb[0]), cut(rgb[1]), cut(rgb[2])};
    double xyz[3];
    relative_xyz(shown, xyz);
    opponents[0] = xyz[1];
    opponents[1] = xyz[0] - xyz[1];
    opponents[2] = xyz[1] - xyz[2];
}

void aob_flip_space_lab(const double opponents[AOB_FLIP_SPACE_OPPONENTS], double lab[3])
{
    const double xyz[3] = {opponents[0] + opponents[1], opponents[0], opponents[0] - opponents[2]};
    double rgb[3];
    rgb_of_relative_xyz(xyz, rgb);
    const double shown[3] = {cut(rgb[0]), cut(rgb[1]), cut(rgb[2])};
    hunt_lab(shown, lab);
}

void aob_flip_space_lab_of_grey(double luminance, double lab[3])
{
    lab[0] = 116 * lab_curve(cut(luminance)) - 16;
    lab[1] = lab[2] = 0;
}

double aob_flip_space_hyab(const double one[3], const double other[3])
{
    return fabs(one[0] - other[0]) + hypot(one[1] - other[1], one[2] - other[2]);
}

double aob_flip_space_largest(void)
{
    static const double green_rgb[3] = {0, 1, 0}, blue_rgb[3] = {0, 0, 1};
    double green[3], blue[3];
    hunt_lab(green_rgb, green);
    hunt_lab(blue_rgb, blue);
    return aob_flip_space_hyab(green, blue);
}
