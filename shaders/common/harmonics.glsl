/* The scene's light and zonal functions, in nine spherical harmonics (view space; l = 0, 1, 2). */

/* What the three bands of the light give at direction d. */
vec3 light_band0() { return 0.28209479 * aob_light(0); }
vec3 light_band1(vec3 d) { return 0.48860251 * (d.y * aob_light(1) + d.z * aob_light(2) + d.x * aob_light(3)); }
vec3 light_band2(vec3 d)
{
    return 1.09254843 * (d.x * d.y * aob_light(4) + d.y * d.z * aob_light(5) + d.x * d.z * aob_light(7))
        + 0.31539157 * (3.0 * d.z * d.z - 1.0) * aob_light(6) + 0.54627422 * (d.x * d.x - d.y * d.y) * aob_light(8);
}

/* The light's radiance from d. */
vec3 light_from(vec3 d) { return light_band0() + light_band1(d) + light_band2(d); }

/* The zonal coefficients of a cosine lobe that is cut at a half-angle of cosine c. */
vec3 cut_cosine(float c)
{
    float s = 1.0 - c * c;
    return vec3(0.5 * sqrt(AOB_PI) * s, sqrt(AOB_PI / 3.0) * (1.0 - c * c * c), sqrt(5.0 * AOB_PI) / 8.0 * s * (1.0 + 3.0 * c * c));
}

/* The light times a zonal function z about d, integrated, over pi: a zonal function's coefficient (l, m) is
 * sqrt(4 pi / (2 l + 1)) z_l Y_lm(d). */
vec3 light_through(vec3 z, vec3 d)
{
    vec3 k = sqrt(4.0 / AOB_PI / vec3(1.0, 3.0, 5.0)) * z;
    return k.x * light_band0() + k.y * light_band1(d) + k.z * light_band2(d);
}
