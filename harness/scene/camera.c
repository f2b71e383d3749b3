#include "camera.h"

static bool finite_vec(struct aob_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

static bool check_pose(struct aob_vec3 eye, struct aob_vec3 target, const char *whose,
                       struct aob_error *error)
{
    if (!finite_vec(eye) || !finite_vec(target))
        return aob_fail(error, "camera: %seye and target must be finite numbers", whose);
    double distance = aob_vec_length(aob_vec_sub(target, eye));
    if (!(distance > 0) || !isfinite(distance))
        return aob_fail(
            error, "camera: %seye and target are the same point (or too far apart): move one of them", whose);
    return true;
}

bool aob_camera_check(const struct aob_camera *camera, struct aob_error *error)
{
    if (!check_pose(camera->eye, camera->target, "", error) ||
        (camera->moves && !check_pose(camera->previous_eye, camera->previous_target, "previous ", error)))
        return false;
    for (int i = 0; i < 2; i++)
        if (!(fabs(camera->shift[i]) <= AOB_SHIFT_MAX))
            return aob_fail(error, "camera: shift %g: must be -%d to %d heights of the image",
                            camera->shift[i], AOB_SHIFT_MAX, AOB_SHIFT_MAX);
    if (!(camera->ortho_height >= 0) || !isfinite(camera->ortho_height))
        return aob_fail(error, "camera: ortho height %g: must be finite and not negative",
                        camera->ortho_height);
    if (camera->ortho_height > 0)
        return true;
    if (!(camera->fov_deg >= 1 && camera->fov_deg <= 170))
        return aob_fail(error, "camera: field of view %g degrees: must be 1 to 170", camera->fov_deg);
    return true;
}

struct aob_frame_axes aob_camera_axes(const struct aob_camera *camera)
{
    struct aob_frame_axes axes;
    axes.back = aob_vec_normalize(aob_vec_sub(camera->eye, camera->target));
    struct aob_vec3 right = aob_vec_cross(aob_vec(0, 1, 0), axes.back);
    /* World up is no guide for a look along the vertical: -Z is then the top of the picture as seen from above. */
    if (aob_vec_length(right) < 1e-9)
        right = aob_vec_cross(aob_vec(0, 0, axes.back.y > 0 ? -1 : 1), axes.back);
    axes.right = aob_vec_normalize(right);
    axes.up = aob_vec_cross(axes.back, axes.right);
    return axes;
}

struct aob_projection aob_camera_projection(const struct aob_camera *camera, int width, int height, int guard)
{
    bool perspective = !(camera->ortho_height > 0);
    double span = perspective ? 2 * tan(camera->fov_deg * (M_PI / 360)) : camera->ortho_height;
    return (struct aob_projection){
        .perspective = perspective,
        .width = width + 2 * guard,
        .height = height + 2 * guard,
        .sx = span / height,
        .sy = span / height,
        .cx = guard + width / 2.0 - camera->shift[0] * height,
        .cy = guard + height / 2.0 + camera->shift[1] * height,
    };
}

void aob_camera_ray(const struct aob_camera *camera, const struct aob_projection *projection, double qx,
                    double qy, struct aob_vec3 *origin, struct aob_vec3 *direction)
{
    struct aob_frame_axes axes = aob_camera_axes(camera);
    struct aob_vec3 across = aob_vec_scale(axes.right, (qx - projection->cx) * projection->sx);
    struct aob_vec3 offset =
        aob_vec_sub(across, aob_vec_scale(axes.up, (qy - projection->cy) * projection->sy));
    if (projection->perspective) {
        *origin = camera->eye;
        *direction = aob_vec_sub(offset, axes.back);
    } else {
        *origin = aob_vec_add(camera->eye, offset);
        *direction = aob_vec_scale(axes.back, -1);
    }
}

struct aob_camera aob_camera_previous(const struct aob_camera *camera)
{
    struct aob_camera previous = *camera;
    if (camera->moves) {
        previous.eye = camera->previous_eye;
        previous.target = camera->previous_target;
    }
    previous.moves = false;
    return previous;
}

struct aob_affine aob_camera_then(const struct aob_camera *camera)
{
    const struct aob_camera before = aob_camera_previous(camera);
    const struct aob_frame_axes now = aob_camera_axes(camera), then = aob_camera_axes(&before);
    const struct aob_vec3 from[3] = {now.right, now.up, now.back}, into[3] = {then.right, then.up, then.back};
    struct aob_affine map;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            map.m[i][j] = aob_vec_dot(into[i], from[j]);
        map.m[i][3] = aob_vec_dot(into[i], aob_vec_sub(camera->eye, before.eye));
    }
    return map;
}

bool aob_camera_project(const struct aob_camera *camera, const struct aob_projection *projection,
                        struct aob_vec3 from_eye, double q[2])
{
    struct aob_frame_axes axes = aob_camera_axes(camera);
    double s = projection->perspective ? -aob_vec_dot(from_eye, axes.back) : 1;
    if (!(s > 0))
        return false;
    q[0] = projection->cx + aob_vec_dot(from_eye, axes.right) / (projection->sx * s);
    q[1] = projection->cy - aob_vec_dot(from_eye, axes.up) / (projection->sy * s);
    return true;
}

static void print_pose(struct aob_vec3 eye, struct aob_vec3 target, struct aob_text *text)
{
    aob_text_add(text, "%.17g %.17g %.17g %.17g %.17g %.17g", eye.x, eye.y, eye.z, target.x, target.y,
                 target.z);
}

void aob_camera_print(const struct aob_camera *camera, bool motion, struct aob_text *text)
{
    print_pose(camera->eye, camera->target, text);
    aob_text_add(text, " %.17g %.17g %.17g %.17g", camera->fov_deg, camera->ortho_height, camera->shift[0],
                 camera->shift[1]);
    if (!motion || !camera->moves)
        return;
    aob_text_add(text, " after ");
    print_pose(camera->previous_eye, camera->previous_target, text);
}
