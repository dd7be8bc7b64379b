# SPDX-License-Identifier: GPL-3.0-or-later
"""The sheet Materials: the constants of those that are shipped, which the calculator takes by name."""
from book import LINE_HEIGHT, letters
from source import materials

# those that the workbook computes with; others follow, for a look
TAKEN = {"E": ("E, MPa", "rw_material_E"), "nu": ("nu", "rw_material_nu"), "yield_stress": ("yield stress, MPa",
                                                                                             "rw_material_yield_stress")}


def write(sheet):
    all_of = materials()
    others = sorted({name for constants in all_of.values() for name, value in constants.items() if not isinstance(value, str)} - set(TAKEN))
    sheet.text(0, 0, "Materials", "title")
    sheet.text(1, 0, "Choose a name in the sheet Calculator. It stands for E, nu and yield stress where the material has them. Stresses in "
                     "MPa. Batches of a metal differ: take your own constants.", "note")
    columns = ["name", *(label for label, _ in TAKEN.values()), *others, "what it is", "source"]
    for column, header in enumerate(columns):
        sheet.text(3, column, header, "header")
    for row, (name, constants) in enumerate(all_of.items(), 4):
        sheet.sheet.set_row(row, 3 * LINE_HEIGHT)
        sheet.text(row, 0, name)
        for column, constant in enumerate([*TAKEN, *others], 1):
            sheet.number(row, column, constants.get(constant))
        sheet.text(row, len(columns) - 2, constants["name"], "wrapped")
        sheet.text(row, len(columns) - 1, constants["source"], "wrapped")
    sheet.name("rw_material_names", 4, 0, len(all_of))
    for column, (_, name) in enumerate(TAKEN.values(), 1):
        sheet.name(name, 4, column, len(all_of))
    sheet.widths(**{"A": 24, f"B_{letters(len(columns) - 3)}": 9, letters(len(columns) - 2): 30, letters(len(columns) - 1): 75})
    sheet.sheet.freeze_panes(4, 1)
    sheet.print(f"A1:{letters(len(columns) - 1)}{4 + len(all_of)}", landscape=True)
