#include "gltf_file.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "base/file.h"
#include "base/memory.h"

enum { GLTF_LIMIT_BITS = 32, HEAD = 12, CHUNK_HEAD = 8, CHUNK_JSON = 0x4e4f534a, CHUNK_BIN = 0x004e4942 };

bool aob_gltf_named(const char *path)
{
    const char *ending = strrchr(path, '.');
    return ending && (strcasecmp(ending, ".gltf") == 0 || strcasecmp(ending, ".glb") == 0);
}

static uint32_t read_u32(const char *bytes)
{
    const unsigned char *b = (const unsigned char *)bytes;
    return b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

/* The texts of a binary file: its first chunk is JSON, and one of bytes may follow. Others are skipped. */
static bool find_chunks(struct aob_gltf_file *file, size_t size, const char **json, size_t *json_size,
                        struct aob_error *error)
{
    uint32_t whole = size >= HEAD ? read_u32(file->bytes + 8) : UINT32_MAX;
    if (size >= HEAD && read_u32(file->bytes + 4) != 2)
        return aob_fail(error, "%s: binary glTF of version %u is not read: save it as glTF 2.0", file->path,
                        read_u32(file->bytes + 4));
    if (whole > size)
        return aob_fail(error, "%s: it has %zu bytes, and its header says %u: the file is cut off",
                        file->path, size, whole);
    for (size_t at = HEAD; at + CHUNK_HEAD <= whole;) {
        size_t length = read_u32(file->bytes + at);
        uint32_t kind = read_u32(file->bytes + at + 4);
        at += CHUNK_HEAD;
        if (length > whole - at)
            return aob_fail(error, "%s: a chunk at byte %zu ends behind the file: the file is damaged",
                            file->path, at - CHUNK_HEAD);
        if (kind == CHUNK_JSON && !*json) {
            *json = file->bytes + at;
            *json_size = length;
        } else if (kind == CHUNK_BIN && !file->chunk) {
            file->chunk = (const unsigned char *)file->bytes + at;
            file->chunk_size = length;
        }
        at += length;
    }
    return *json || aob_fail(error, "%s: it has no JSON chunk: the file is damaged", file->path);
}

/* A file that says no version is told by its form: glTF 1 has objects where glTF 2 has arrays. */
static bool read_version(struct aob_gltf_file *file, struct aob_error *error)
{
    const char *version = json_string_value(json_object_get(json_object_get(file->root, "asset"), "version"));
    if (!version)
        version = json_is_object(json_object_get(file->root, "meshes")) ? "1.0" : "2.0";
    file->version = strncmp(version, "1.", 2) == 0 ? 1 : 2;
    return file->version == 1 || strncmp(version, "2.", 2) == 0 ||
           aob_fail(error, "%s: it is glTF of version '%s': 2.0 is read", file->path, version);
}

static bool parse(struct aob_gltf_file *file, const char *json, size_t size, struct aob_error *error)
{
    json_error_t problem;
    if (size >= 3 && memcmp(json, "\xef\xbb\xbf", 3) == 0) { /* a byte order mark, which readers may skip */
        json += 3;
        size -= 3;
    }
    file->root = json_loadb(json, size, JSON_ALLOW_NUL, &problem);
    if (!json_is_object(file->root))
        return aob_fail(error, "%s: line %d: %s: it is no glTF, or the file is damaged", file->path,
                        file->root ? 1 : problem.line, file->root ? "no JSON object" : problem.text);
    return read_version(file, error);
}

bool aob_gltf_file_read(struct aob_gltf_file *file, const char *path, struct aob_error *error)
{
    size_t size = 0, json_size;
    *file = (struct aob_gltf_file){.path = path};
    file->bytes = aob_file_read(path, (size_t)1 << GLTF_LIMIT_BITS, &size, error);
    if (!file->bytes)
        return false;
    const char *json = file->bytes;
    json_size = size;
    if (size >= 4 && memcmp(file->bytes, "glTF", 4) == 0) {
        json = NULL;
        if (!find_chunks(file, size, &json, &json_size, error))
            goto error;
    }
    if (parse(file, json, json_size, error))
        return true;
error:
    aob_gltf_file_finish(file);
    return false;
}

void aob_gltf_file_finish(struct aob_gltf_file *file)
{
    json_decref(file->root);
    free(file->bytes);
    *file = (struct aob_gltf_file){0};
}

static int hex_digit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    c |= 0x20;
    return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/* Decodes %XX in place; the new size. */
static size_t decode_percent(char *text)
{
    char *to = text;
    for (const char *from = text; *from; from++)
        if (*from == '%' && hex_digit(from[1]) >= 0 && hex_digit(from[2]) >= 0) {
            *to++ = (char)(hex_digit(from[1]) << 4 | hex_digit(from[2]));
            from += 2;
        } else
            *to++ = *from;
    *to = '\0';
    return (size_t)(to - text);
}

char *aob_gltf_uri_path(const char *path, const char *uri)
{
    char *plain = aob_strdup(uri);
    decode_percent(plain);
    char *decoded = aob_path_beside(path, plain), *literal = aob_path_beside(path, uri);
    free(plain);
    bool take_literal = !aob_file_exists(decoded) && aob_file_exists(literal);
    free(take_literal ? decoded : literal);
    return take_literal ? literal : decoded;
}

bool aob_gltf_uri_is_data(const char *uri)
{
    return strncasecmp(uri, "data:", 5) == 0;
}

static int base64_digit(char c)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = c ? strchr(digits, c) : NULL;
    return at ? (int)(at - digits) : c == '-' ? 62 : c == '_' ? 63 : -1;
}

static unsigned char *decode_base64(const char *text, size_t *size)
{
    size_t length = strcspn(text, "="), rest = strspn(text + length, "=");
    if (text[length + rest] || rest > 2 || length % 4 == 1)
        return NULL;
    unsigned char *bytes = aob_alloc(length + 1, 1);
    uint32_t group = 0;
    *size = 0;
    for (size_t i = 0; i < length; i++) {
        int digit = base64_digit(text[i]);
        if (digit < 0) {
            free(bytes);
            return NULL;
        }
        group = group << 6 | (uint32_t)digit;
        if (i % 4)
            bytes[(*size)++] = (unsigned char)(group >> (6 - 2 * (i % 4)));
    }
    return bytes;
}

unsigned char *aob_gltf_uri_data(const char *uri, size_t *size)
{
    static const char mark[] = ";base64";
    const char *comma = strchr(uri, ',');
    if (!aob_gltf_uri_is_data(uri) || !comma)
        return NULL;
    if ((size_t)(comma - uri) >= sizeof mark - 1 &&
        memcmp(comma - (sizeof mark - 1), mark, sizeof mark - 1) == 0)
        return decode_base64(comma + 1, size);
    char *bytes = aob_strdup(comma + 1);
    *size = decode_percent(bytes);
    return (unsigned char *)bytes;
}
