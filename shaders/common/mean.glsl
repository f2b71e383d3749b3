/* A mean of unit vectors is no longer than 1. What is left of the hemisphere when a few directions have closed it may be, since
 * each of them stands for many. */
vec3 bounded_mean(vec3 mean) { return mean * inversesqrt(max(dot(mean, mean), 1.0)); }
