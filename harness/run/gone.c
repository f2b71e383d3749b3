#include "gone.h"
#include <stdlib.h>
#include "base/file.h"
#include "base/text.h"
#include "scene/scene_folder.h"
#include "scene/source.h"

struct places { /* that files are looked for in */
    const char *config;
    struct aob_scene_folder folder; /* of the user */
    struct aob_error folder_error;  /* why it cannot be read; empty: it can, or is not set */
};

static bool is_readable(const char *file, struct aob_error *why)
{
    char digest[AOB_KEY_SIZE];
    return aob_source_digest(NULL, file, digest, why);
}

static bool is_in_folder(const struct places *places, const char *name, struct aob_error *why)
{
    const char *path = aob_scene_folder_find(&places->folder, name), *folder = getenv("AOBUDGET_SCENES");
    if (path)
        return is_readable(path, why) || aob_fail_in(why, "%s", name);
    if (*places->folder_error.text)
        return aob_fail(why, "%s: %s", name, places->folder_error.text);
    if (!folder || !*folder)
        return aob_fail(why, "%s was in the folder AOBUDGET_SCENES, which is not set", name);
    return aob_fail(why, "%s is not there any more, as seen in AOBUDGET_SCENES, %s", name, folder);
}

static bool is_there(const struct places *places, const struct aob_scene_choice *choice,
                     struct aob_error *why)
{
    const struct aob_scene_info *info = choice->name ? aob_scene_find(choice->name) : NULL;
    const char *file = choice->capture ? choice->capture : choice->file;
    if (file && !aob_file_exists(file))
        return aob_fail(why, "%s%s is not there any more, as seen from %s", choice->capture ? "capture:" : "",
                        choice->given, places->config);
    if (file)
        return choice->capture || is_readable(file, why);
    if (info && info->file && !aob_file_exists(info->file))
        return aob_fail(why, "%s: %s is not there any more (apt-get install %s)", info->name, info->file,
                        info->package);
    return info || is_in_folder(places, choice->name, why);
}

static void tell_of(const struct aob_scene_choice *choice, const char *why, aob_gone_fn tell, void *user)
{
    struct aob_text name = {0};
    aob_text_add(&name, "%s%s", choice->capture ? "capture:" : "",
                 choice->name ? choice->name : choice->given);
    tell(user, name.data, why);
    aob_text_finish(&name);
}

void aob_gone_leave(struct aob_config *config, aob_gone_fn tell, void *user)
{
    struct places places = {.config = config->place};
    size_t kept = 0;
    if (aob_scene_folder_read(&places.folder, &places.folder_error))
        *places.folder_error.text = '\0';
    for (size_t i = 0; i < config->scene_count; i++) {
        struct aob_scene_choice *choice = &config->scenes[i];
        struct aob_error why = {{0}};
        if (is_there(&places, choice, &why)) {
            config->scenes[kept++] = *choice;
            continue;
        }
        tell_of(choice, why.text, tell, user);
        aob_scene_choice_finish(choice);
    }
    config->scene_count = kept;
    aob_scene_folder_finish(&places.folder);
}
