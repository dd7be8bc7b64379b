/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the lines of data/sheets.tsv say is written here: a function for each kind of line. */
#include "workbook.h"

#include "table/table.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <rwedge.h>

/* The fields of most lines. */
enum { KIND, PLACE, STYLE, TEXT, NAME, LAST };

typedef struct {
    xlsx *book;
    const yield_table *table;
    case_values values; /* of the calculator's case */
    xlsx_area at;       /* the cells of the line */
    bool has_rows;      /* it is Batch: names are cells of a row */
    range down, across; /* the last of these lines */
} sheets;

typedef void line_writer(sheets *on, const char *const f[]);

static void name_cells(const sheets *on, const char *name)
{
    if (name[0] != '\0')
        xlsx_name(on->book, name, on->at);
}

/* ---- Texts and formulas ---- */

static void write_text(sheets *on, const char *const f[])
{
    xlsx_text(on->book, on->at.row, on->at.column, f[TEXT], f[STYLE]);
}

/* Letters are narrower on average than the digits that widths count. */
static void write_paragraph(sheets *on, const char *const f[])
{
    enum { LINE_LENGTH = 88 };
    xlsx_lines(on->book, on->at.row, 1 + (int)strlen(f[TEXT]) / LINE_LENGTH);
    write_text(on, f);
}

static void write_made(sheets *on, const char *const f[])
{
    char text[1200];
    snprintf(text, sizeof text, "Written by rwedge %s with the command:  %s", rwedge_version(),
             invocation());
    write_paragraph(on, (const char *const[]){[STYLE] = f[STYLE], [TEXT] = text});
}

/* With a value that is a number, a result or a text. */
static void write_formula(sheets *on, const char *const f[])
{
    const char *style = f[STYLE];
    const char *text = strcmp(f[LAST], "strength") == 0  ? on->values.strength
                       : strcmp(f[LAST], "figures") == 0 ? on->values.figures
                                                         : f[LAST];
    const int result = cell_of_column(text);
    double value = result >= 0 ? on->values.number[result] : NAN;
    const bool is_number = result >= 0 || number_read(text, &value);
    for (int row = on->at.row; row <= on->at.last_row; row++)
        xlsx_formula(on->book, row, on->at.column, formula_of(f[TEXT], row + 1, 0),
                     is_number ? cell_number(value) : cell_text(text), style);
    name_cells(on, f[NAME]);
}

static void write_case(sheets *on, const char *const f[])
{
    enum { LABEL, CELL, VALUE, UNIT, HINT };
    const int row = on->at.row, number = cell_of_column(f[TEXT]);
    const case_cell *as = &case_cells[number];
    xlsx_text(on->book, row, LABEL, as->label, "plain");
    xlsx_text(on->book, row, CELL, as->name, "note");
    xlsx_text(on->book, row, UNIT, as->unit, "unit");
    xlsx_text(on->book, row, HINT, as->hint, "note");
    const xlsx_area area = {row, VALUE, row, VALUE};
    xlsx_name(on->book, as->name, area);
    if (number >= INPUT_CELLS) {
        case_formula(on->book, row, VALUE, number, &on->values, f[STYLE], 0);
        return;
    }
    xlsx_number(on->book, row, VALUE, on->values.number[number], f[STYLE]);
    check_typing(on->book, area, number, 0);
}

/* The working cells of the calculator, side by side: label, name, formula. */
static void write_working(sheets *on, const char *const f[])
{
    const int row = on->at.row, value_row = row + 2;
    (void)f;
    for (int i = FIRST_REMARK; i < case_cell_count; i++) {
        const case_cell *as = &case_cells[i];
        const int column = i - FIRST_REMARK;
        xlsx_text(on->book, row, column, as->label, "note");
        xlsx_text(on->book, row + 1, column, as->name, "note");
        case_formula(on->book, value_row, column, i, &on->values, "plain", 0);
        xlsx_name(on->book, as->name, (xlsx_area){value_row, column, value_row, column});
        if (i >= SHOWN_CELLS && as->column[0] != '\0')
            xlsx_name(on->book, as->column, (xlsx_area){value_row, column, value_row, column + 2});
    }
}

/* Inputs left, results right, named as "solve --input" names its columns; then the working cells,
 * which are hidden. A row refers to itself and to the tables alone: it may be copied. */
enum { BATCH_HEADER, BATCH_FIRST, BATCH_ROWS = 200 };

static void write_batch_rows(xlsx *book)
{
    case_values values;
    for (int row = BATCH_FIRST; row < BATCH_FIRST + BATCH_ROWS; row++) {
        shown_values(1 + row - BATCH_FIRST, &values);
        xlsx_text(book, row, 0, "", "bare");
        for (int i = 0; i < INPUT_CELLS; i++)
            xlsx_number(book, row, batch_column(i), values.number[i], "bare");
        for (int i = INPUT_CELLS; i < case_cell_count; i++)
            case_formula(book, row, batch_column(i), i, &values, "plain", row + 1);
    }
}

static void write_batch(sheets *on, const char *const f[])
{
    const int last = batch_column(case_cell_count);
    (void)f;
    on->has_rows = true;
    xlsx_text(on->book, BATCH_HEADER, 0, "case", "header");
    for (int i = 0; i < case_cell_count; i++)
        xlsx_text(on->book, BATCH_HEADER, batch_column(i),
                  i < SHOWN_CELLS ? case_cells[i].column : case_cells[i].name,
                  i < FIRST_REMARK ? "upright" : "header");
    write_batch_rows(on->book);
    /* the last row that has an input, beside the hidden names */
    xlsx_formula(on->book, BATCH_HEADER, last,
                 "=MAX(1,SUMPRODUCT(MAX((Batch!$B$2:$N$10000<>\"\")*ROW(Batch!$B$2:$N$10000))))",
                 cell_number(BATCH_FIRST + EXAMPLES - 1), "plain");
    xlsx_name(on->book, "rwt_used", (xlsx_area){BATCH_HEADER, last, BATCH_HEADER, last});
    /* what is typed or pasted is checked: typing at once, pasting by the column "error" */
    for (int i = 0; i < INPUT_CELLS; i++)
        check_typing(on->book,
                     (xlsx_area){BATCH_FIRST, batch_column(i), BATCH_ROWS, batch_column(i)}, i,
                     BATCH_FIRST + 1);
    xlsx_hide_columns(on->book, batch_column(SHOWN_CELLS), last);
}

/* ---- Numbers ---- */

/* So many rows and columns on from the place of the line; nothing where it is not finite. */
static void put(const sheets *on, int down, int across, double value, const char *style)
{
    if (isfinite(value))
        xlsx_number(on->book, on->at.row + down, on->at.column + across, value, style);
}

/* Down, or across. */
static void write_list(sheets *on, const char *const f[])
{
    const bool is_down = strcmp(f[KIND], "down") == 0;
    range *values = is_down ? &on->down : &on->across;
    range_read(f[TEXT], values);
    for (int i = 0; i < values->count; i++)
        put(on, is_down ? i : 0, is_down ? 0 : i, range_value(values, i), f[STYLE]);
    *(is_down ? &on->at.last_row : &on->at.last_column) += (int)values->count - 1;
    name_cells(on, f[NAME]);
}

/* Numbers that are computed for it, or formulas that have these values. */
static void write_data(sheets *on, const char *const f[])
{
    int rows, columns;
    const double *value = yield_table_numbers(on->table, f[TEXT], &rows, &columns);
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++, value++)
            if (f[LAST][0] == '\0')
                put(on, i, j, *value, f[STYLE]);
            else
                xlsx_formula(on->book, on->at.row + i, on->at.column + j,
                             formula_of(f[LAST], i + 1, 0), cell_number(*value), f[STYLE]);
    on->at.last_row += rows - 1;
    on->at.last_column += columns - 1;
    name_cells(on, f[NAME]);
}

static int variable_named(const char *column)
{
    int i = 0;
    while (i < VARIABLE_COUNT && strcmp(variables[i].column, column) != 0)
        i++;
    return i;
}

/* A quantity of "rwedge table" under normal load and for nu = 0.3 where these are no variables. */
static double quantity(const table *from, const char *name, const double value[])
{
    cell row[COLUMNS_MAX];
    int i = 0;
    while (strcmp(from->quantity[i], name) != 0)
        i++;
    if (from->row(value, row) != RWEDGE_OK)
        failure("the workbook: a value of its tables could not be computed");
    return row[i].number;
}

static void write_grid(sheets *on, const char *const f[])
{
    enum { TABLE = TEXT, QUANTITY, DOWN, ACROSS, GRID_NAME };
    const table *from = table_named(f[TABLE], false);
    const int down = variable_named(f[DOWN]), across = variable_named(f[ACROSS]);
    const int columns = across < VARIABLE_COUNT ? (int)on->across.count : 1;
    double value[VARIABLE_COUNT + 1] = {[NU] = 0.3};
    for (int i = 0; i < on->down.count; i++)
        for (int j = 0; j < columns; j++) {
            value[down] = range_value(&on->down, i);
            value[across] = across < VARIABLE_COUNT ? range_value(&on->across, j) : 0;
            put(on, i, j, number_rounded(quantity(from, f[QUANTITY], value), XLSX_DIGITS),
                f[STYLE]);
        }
    on->at.last_row += (int)on->down.count - 1;
    on->at.last_column += columns - 1;
    name_cells(on, f[GRID_NAME]);
}

/* a/b, f, and the formula that interpolates the table. */
static void write_look_up(sheets *on, const char *const f[])
{
    double tip = NAN, friction = NAN;
    const bool is_given = number_read(f[STYLE], &tip) && number_read(f[TEXT], &friction);
    for (int row = on->at.row; row <= on->at.last_row; row++) {
        xlsx_number(on->book, row, 0, tip, "input");
        xlsx_number(on->book, row, 1, friction, "input");
        xlsx_formula(on->book, row, 2, formula_of("look_up(A~,B~)", row + 1, 0),
                     cell_number(is_given ? rwedge_elastic_limit(tip, friction, 0.3) : NAN),
                     "result");
    }
}

/* ---- Properties ---- */

static void turn_to_sheet(sheets *on, const char *const f[])
{
    xlsx_sheet(on->book, f[PLACE]);
    on->has_rows = false;
}

/* Those of the room sheet. A text that begins with "=" is a formula, or the range of a curve. */
static void set_property(sheets *on, const char *const f[])
{
    const char *texts[FIELDS];
    for (int i = 0; i < FIELDS; i++)
        texts[i] = f[i][0] == '=' && f[i][1] != '\''
                       ? formula_of(f[i] + 1, 0, on->has_rows ? on->at.row + 1 : 0)
                       : f[i];
    xlsx_property(on->book, f[KIND], on->at, &texts[PLACE]);
}

/* ---- The lines ---- */

static const struct {
    const char *name; /* NULL for all properties */
    line_writer *write;
} kinds[] = {
    {"sheet", turn_to_sheet},   {"text", write_text},       {"paragraph", write_paragraph},
    {"made", write_made},       {"formula", write_formula}, {"case", write_case},
    {"working", write_working}, {"batch", write_batch},     {"down", write_list},
    {"across", write_list},     {"data", write_data},       {"grid", write_grid},
    {"look_up", write_look_up}, {NULL, set_property},
};

/* A place is cells as "A1" or "A1:C9", the cell below the last where there is no text; other texts
 * are none. */
void book_write(output *out)
{
    const char *const *next = sheets_lines, *f[FIELDS];
    cells_read();
    sheets on = {.book = xlsx_begin(out, "rwedge: contact of a rounded wedge", false)};
    shown_values(0, &on.values);
    on.table = yield_table_make(&on.values);
    while (workbook_line(&next, f)) {
        int i = 0;
        while (kinds[i].name != NULL && strcmp(kinds[i].name, f[KIND]) != 0)
            i++;
        const size_t letters = strspn(f[PLACE], "ABCDEFGHIJKLMNOPQRSTUVWXYZ");
        if (letters > 0 && isdigit((unsigned char)f[PLACE][letters]))
            on.at = xlsx_area_of(f[PLACE]);
        else if (f[PLACE][0] == '\0')
            on.at = (xlsx_area){on.at.last_row + 1, on.at.column, on.at.last_row + 1, on.at.column};
        kinds[i].write(&on, f);
    }
    xlsx_hide_names(on.book, "rwt_");
    xlsx_finish(on.book);
}
