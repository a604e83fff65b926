#!/usr/bin/env python3
"""Writes the workbooks of tests/data/instruments/ with two libraries that others wrote: openpyxl and XlsxWriter.

The data are the sweeps of instrument_files.py. The files differ from one run to the next in their dates alone.

    apt-get install python3-openpyxl python3-xlsxwriter
    python3 tests/reference/workbooks.py
"""
import openpyxl
import xlsxwriter

from instrument_files import PLACE, rows

NAMES = ("Temperature", "Frequency", "Storage modulus G'", "Loss modulus G\"", "Remark")
UNITS = ("°C", "Hz", "MPa", "MPa", "")

# A sheet of notes before the one with the table, which begins in column B below a preamble.
book = openpyxl.Workbook()
book.active.title = "About"
book.active["A1"] = "Frequency sweeps of a known solid; no instrument made them"
sheet = book.create_sheet("Sweeps")
sheet["B1"] = "Test"
sheet["C1"] = "Oscillation"
sheet.append([])
for line in (NAMES, UNITS):
    sheet.append([None, *line])
for celsius, frequency, storage, loss in rows((10, 20, 30)):
    sheet.append([None, celsius, frequency, storage / 1e6, loss / 1e6])
sheet["F5"] = "first point, repeated"
book.save(PLACE / "openpyxl.xlsx")

# Formats of numbers, a formula, a name with a line break, a hidden sheet with an older table, columns in other order.
with xlsxwriter.Workbook(str(PLACE / "xlsxwriter.xlsx")) as book:
    sheet = book.add_worksheet("DMA")
    scientific = book.add_format({"num_format": "0.00E+00"})
    day = book.add_format({"num_format": "yyyy-mm-dd hh:mm"})
    for column, name in enumerate(("Measured on", "G'\n[Pa]", "G'' [Pa]", "omega [rad/s]", "Temp. [°C]")):
        sheet.write(0, column, name)
    for row, (celsius, frequency, storage, loss) in enumerate(rows((10, 20, 30)), start=1):
        sheet.write_number(row, 0, 46000.5 + row / 1440, day)
        sheet.write_number(row, 1, storage, scientific)
        sheet.write_number(row, 2, loss, scientific)
        omega = 6.283185307179586 * frequency
        sheet.write_formula(row, 3, f"=2*PI()*{frequency!r}", scientific, omega)
        sheet.write_number(row, 4, celsius)
    old = book.add_worksheet("Old")
    old.write_row(0, 0, ("omega [rad/s]", "G' [Pa]", "G'' [Pa]"))
    old.write_row(1, 0, (1.0, 2.0, 3.0))
    old.hide()
