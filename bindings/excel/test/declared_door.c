/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers the calls of tests/doors/calls.py from standard input, as Excel would: the
 * declarations are read from rwedge.bas, the library is loaded by its path, and each function is
 * called through DispCallFunc, OLE Automation's way to call what is only known by its types.
 * Each line is printed back with the bits of its results, like tests/doors/door.c does.
 *
 *     declared_door.exe RWEDGE.DLL RWEDGE.BAS < CALLS
 *     declared_door.exe RWEDGE.DLL RWEDGE.BAS time
 *
 * The latter prints the nanoseconds of a call, directly and by DispCallFunc.
 *
 * The arguments of a line are used up in turn, but by objects and sizes; what is passed by
 * reference after the last of them receives results. An object that is made takes the place of
 * the one before, which is not freed. */
#include <windows.h>

#include <oleauto.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_PARAMETERS = 16, MAX_FUNCTIONS = 200, MOST = 64 /* numbers of an array */ };
typedef enum { NO_HANDLE, CONTACT, SERIES } handle;

typedef struct {
    char name[64];
    VARTYPE result; /* VT_EMPTY: a Sub */
    int parameters;
    VARTYPE types[MAX_PARAMETERS];
    handle handles[MAX_PARAMETERS];
    FARPROC address;
} function;

static function functions[MAX_FUNCTIONS];
static int function_count;
static LONGLONG objects[3]; /* one contact and one series at a time */
static double before[MOST]; /* what the line before gave */
static int count_before;

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
        f->handles[f->parameters++] = strcmp(name, "contact") == 0  ? CONTACT
                                      : strcmp(name, "series") == 0 ? SERIES
                                                                    : NO_HANDLE;
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

typedef struct {
    double v[MOST];
    int count;
} numbers;

static numbers numbers_of(const char *text)
{
    numbers a = {{0}, 0};
    if (*text == '@') {
        memcpy(a.v, before, sizeof a.v);
        a.count = count_before;
        return a;
    }
    for (char *end; a.count < MOST && *text && *text != ','; text = end)
        a.v[a.count++] = strtod(text, &end);
    return a;
}

/* The size in front of an array is the number of its elements: that of the next list among the
 * arguments. */
static int size_at(const function *f, const numbers given[], const char is_given[], int i)
{
    for (; i < f->parameters; i++)
        if (is_given[i] && f->types[i] == (VT_BYREF | VT_R8))
            return given[i].count;
    return 0;
}

/* Gives the numbers of the line to the parameters in turn, but to objects and sizes. */
static void read_arguments(const function *f, const char *line, numbers given[], char is_given[])
{
    const char *text = strchr(line, ',');
    for (int i = 0; i < f->parameters; i++) {
        is_given[i] = text && f->handles[i] == NO_HANDLE && f->types[i] != VT_I8;
        if (!is_given[i])
            continue;
        given[i] = numbers_of(text + 1);
        text = strchr(text + 1, ',');
    }
    if (text)
        give_up("too many arguments", line);
}

static void print_results(const char *line, const function *f, const numbers results[],
                          const char is_given[])
{
    int outputs = 0, all = 0;
    sscanf(line, "%*[a-z_]:%d:%d", &outputs, &all);
    count_before = 0;
    for (int i = 0; i < f->parameters; i++) {
        if (is_given[i] || f->types[i] != (VT_BYREF | VT_R8))
            continue;
        for (int j = 0; j < all / outputs; j++) {
            print_bits(results[i].v[j]);
            if (count_before < MOST)
                before[count_before++] = results[i].v[j];
        }
    }
}

/* A Long is a status, but where the line expects a result that no parameter receives. */
static int is_status(const char *line, const function *f, const char is_given[])
{
    int outputs = 0;
    sscanf(line, "%*[a-z_]:%d", &outputs);
    for (int i = 0; i < f->parameters; i++)
        outputs -= !is_given[i] && f->types[i] == (VT_BYREF | VT_R8);
    return f->result == VT_I4 && outputs <= 0;
}

static void answer(const char *line)
{
    static numbers given[MAX_PARAMETERS];
    char name[64], is_given[MAX_PARAMETERS];
    VARIANT arguments[MAX_PARAMETERS];
    sscanf(line, "%63[a-z_]", name);
    const function *f = function_named(name);
    read_arguments(f, line, given, is_given);
    for (int i = 0; i < f->parameters; i++) {
        VARIANT *v = &arguments[i];
        VariantInit(v);
        V_VT(v) = f->types[i];
        switch (f->types[i]) {
        case VT_R8:
            V_R8(v) = given[i].v[0];
            break;
        case VT_I4:
            V_I4(v) = (LONG)given[i].v[0];
            break;
        case VT_I8:
            V_I8(v) = f->handles[i] ? objects[f->handles[i]] : size_at(f, given, is_given, i);
            break;
        case VT_BYREF | VT_I8:
            V_I8REF(v) = &objects[f->handles[i]];
            break;
        case VT_BYREF | VT_R8:
            V_R8REF(v) = given[i].v;
            break;
        default:
            give_up("cannot be passed", f->name);
        }
    }
    VARIANT result = call(f, arguments);
    printf("%s", line);
    if (f->result == VT_R8)
        print_bits(V_R8(&result));
    else if (f->result == VT_I8) /* the address of a text */
        print_bits((double)strlen((const char *)V_I8(&result)));
    else if (f->result == VT_I4 && !is_status(line, f, is_given))
        print_bits((double)V_I4(&result));
    else if (f->result == VT_I4 && V_I4(&result) != 0)
        printf(",error");
    else
        print_results(line, f, given, is_given);
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
    char line[1024];
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\r\n")] = 0;
        answer(line);
    }
    return 0;
}
