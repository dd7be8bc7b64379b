/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers the calls of tests/doors/calls.sh from standard input, as Excel would: the
 * declarations are read from rwedge.bas, the library is loaded by its path, and each function is
 * called through DispCallFunc, OLE Automation's way to call what is only known by its types.
 * Each line is printed back with the bits of its results, like tests/doors/door.c does.
 *
 *     declared_door.exe RWEDGE.DLL RWEDGE.BAS < CALLS
 *     declared_door.exe RWEDGE.DLL RWEDGE.BAS time
 *
 * The latter prints the nanoseconds of a call, directly and by DispCallFunc.
 *
 * The arguments of a line are used up in turn; what is passed by reference after the last of
 * them receives a result. */
#include <windows.h>

#include <oleauto.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_PARAMETERS = 12, MAX_FUNCTIONS = 100 };

typedef struct {
    char name[64];
    VARTYPE result; /* VT_EMPTY: a Sub */
    int parameters;
    VARTYPE types[MAX_PARAMETERS];
    int is_handle[MAX_PARAMETERS];
    FARPROC address;
} function;

static function functions[MAX_FUNCTIONS];
static int function_count;
static LONGLONG contact;

static void give_up(const char *what, const char *which)
{
    fprintf(stderr, "%s: %s\n", which, what);
    exit(1);
}

static VARTYPE type_named(const char *name)
{
    static const struct {
        const char *name;
        VARTYPE type;
    } types[] = {
        {"Double", VT_R8}, {"LongPtr", VT_I8}, {"Long", VT_I4}}; /* the longer name first */
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++)
        if (strncmp(name, types[i].name, strlen(types[i].name)) == 0)
            return types[i].type;
    give_up("unknown type", name);
    return VT_EMPTY;
}

/* "Private Declare PtrSafe Function c_load Lib "rwedge.dll" Alias "rwedge_load" (ByVal alpha As
 * Double) As Double" */
static void declare(char *line, HMODULE library)
{
    char *alias = strstr(line, "Alias \"rwedge_"), *open = strchr(line, '('),
         *close = strchr(line, ')');
    if (!strstr(line, "Lib \"rwedge.dll\""))
        return;
    if (!alias || !open || !close || function_count == MAX_FUNCTIONS)
        give_up("not understood", line);
    function *f = &functions[function_count++];
    sscanf(alias, "Alias \"rwedge_%63[a-z_]\"", f->name);
    char symbol[80];
    snprintf(symbol, sizeof symbol, "rwedge_%s", f->name);
    f->address = GetProcAddress(library, symbol);
    if (!f->address)
        give_up("not in the library", symbol);
    f->result = strncmp(close, ") As ", 5) == 0 ? type_named(close + 5) : VT_EMPTY;
    *close = 0;
    for (char *p = strtok(open + 1, ","); p; p = strtok(NULL, ",")) {
        char how[8], name[32], type[16];
        if (f->parameters == MAX_PARAMETERS || sscanf(p, " %7s %31s As %15s", how, name, type) != 3)
            give_up("not understood", p);
        f->types[f->parameters] = type_named(type) | (strcmp(how, "ByRef") == 0 ? VT_BYREF : 0);
        f->is_handle[f->parameters++] = strcmp(name, "contact") == 0;
    }
}

/* Reads the declarations, each on one line or several that end in " _". */
static void read_module(const char *path, HMODULE library)
{
    FILE *file = fopen(path, "r");
    char line[512], joined[2048] = "";
    if (!file)
        give_up("cannot be read", path);
    while (fgets(line, sizeof line, file)) {
        line[strcspn(line, "\r\n")] = 0;
        const size_t length = strlen(line);
        const int goes_on = length > 2 && strcmp(line + length - 2, " _") == 0;
        if (goes_on)
            line[length - 2] = 0;
        if (strlen(joined) + length < sizeof joined)
            strcat(joined, line);
        if (goes_on)
            continue;
        if (strncmp(joined, "Private Declare PtrSafe", 23) == 0)
            declare(joined, library);
        joined[0] = 0;
    }
    fclose(file);
}

static const function *function_named(const char *name)
{
    for (int i = 0; i < function_count; i++)
        if (strcmp(functions[i].name, name) == 0)
            return &functions[i];
    give_up("no such function", name);
    return NULL;
}

static VARIANT call(const function *f, VARIANT *arguments)
{
    VARIANT result, *pointers[MAX_PARAMETERS];
    for (int i = 0; i < f->parameters; i++)
        pointers[i] = &arguments[i];
    VariantInit(&result);
    const HRESULT outcome =
        DispCallFunc(NULL, (ULONG_PTR)f->address, CC_STDCALL, f->result, (UINT)f->parameters,
                     (VARTYPE *)f->types, pointers, &result);
    if (FAILED(outcome))
        give_up("DispCallFunc fails", f->name);
    return result;
}

static void print_bits(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    if (value == value)
        printf(",%08lx%08lx", (unsigned long)(bits >> 32), (unsigned long)(bits & 0xffffffff));
    else
        printf(",nan");
}

static void answer(const char *line)
{
    char text[256];
    double given[MAX_PARAMETERS], results[MAX_PARAMETERS];
    int result_count = 0;
    VARIANT arguments[MAX_PARAMETERS];
    snprintf(text, sizeof text, "%s", line);
    const function *f = function_named(strtok(text, ","));
    if (strcmp(f->name, "contact_create") == 0)
        contact = 0;
    for (int i = 0; i < f->parameters; i++) {
        VARIANT *v = &arguments[i];
        VariantInit(v);
        V_VT(v) = f->types[i];
        const char *word = f->is_handle[i] || f->types[i] == VT_I8 ? NULL : strtok(NULL, ",");
        switch (f->types[i]) {
        case VT_R8:
            V_R8(v) = strtod(word, NULL);
            break;
        case VT_I4:
            V_I4(v) = atol(word);
            break;
        /* or the length of the arrays */
        case VT_I8:
            V_I8(v) = f->is_handle[i] ? contact : 1;
            break;
        case VT_BYREF | VT_I8:
            V_I8REF(v) = &contact;
            break;
        case VT_BYREF | VT_R8:
            if (word)
                given[i] = strtod(word, NULL);
            V_R8REF(v) = word ? &given[i] : &results[result_count++];
            break;
        default:
            give_up("cannot be passed", f->name);
        }
    }
    VARIANT result = call(f, arguments);
    if (f->result == VT_I4 && V_I4(&result) != 0)
        give_up("fails", line);
    printf("%s", line);
    if (f->result == VT_R8)
        print_bits(V_R8(&result));
    for (int i = 0; i < result_count; i++)
        print_bits(results[i]);
    printf("\n");
}

static double seconds(void)
{
    LARGE_INTEGER count, frequency;
    QueryPerformanceCounter(&count);
    QueryPerformanceFrequency(&frequency);
    return (double)count.QuadPart / (double)frequency.QuadPart;
}

static void measure(void)
{
    enum { CALLS = 1000000 };
    const function *f = function_named("load");
    double (*load)(double) = (double (*)(double))(void (*)(void))f->address;
    VARIANT argument;
    VariantInit(&argument);
    V_VT(&argument) = VT_R8;
    double sum = 0, same_sum = 0, start = seconds();
    for (int i = 0; i < CALLS; i++)
        sum += load(i * 1e-6);
    const double directly = seconds() - start;
    start = seconds();
    for (int i = 0; i < CALLS; i++) {
        V_R8(&argument) = i * 1e-6;
        VARIANT result = call(f, &argument);
        same_sum += V_R8(&result);
    }
    const double by_types = seconds() - start;
    printf("rwedge_load: %.0f ns directly, %.0f ns by DispCallFunc%s\n", directly / CALLS * 1e9,
           by_types / CALLS * 1e9, sum == same_sum ? "" : ", AND ANOTHER RESULT");
}

/* The library with its floating-point mode: loaded into Excel it must leave that alone. The x87
 * is set as Windows sets it for programs of Microsoft's compilers, to 53 bits. */
static HMODULE loaded(const char *path)
{
    const uint16_t windows_mode = 0x27f;
    uint16_t mode = 0;
    uint32_t sse_before = 0, sse = 0;
    __asm__ volatile("fldcw %0" : : "m"(windows_mode));
    __asm__ volatile("stmxcsr %0" : "=m"(sse_before));
    HMODULE library = LoadLibraryA(path);
    if (!library)
        give_up("cannot be loaded", path);
    __asm__ volatile("fnstcw %0" : "=m"(mode));
    __asm__ volatile("stmxcsr %0" : "=m"(sse));
    if (mode != windows_mode || sse != sse_before)
        give_up("loading it changes the floating-point mode", path);
    return library;
}

int main(int count, char **arguments)
{
    if (count < 3)
        give_up("needs RWEDGE.DLL RWEDGE.BAS", arguments[0]);
    read_module(arguments[2], loaded(arguments[1]));
    if (count > 3) {
        measure();
        return 0;
    }
    char line[256];
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\r\n")] = 0;
        answer(line);
    }
    return 0;
}
