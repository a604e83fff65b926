#!/usr/bin/env python3
"""Writes tests/data/instruments/: frequency sweeps of a known solid in the forms in which instruments export them.

The solid is G*(omega, T) of three Maxwell elements beside a spring, with the shift law of Williams, Landel and Ferry
(c1 = 10, c2 = 100 K at 20 degC); in tension E = 3 G. Headers follow the habits of rheometers and analysers; no file is
a copy of one. Ten files are sound, five are not. workbooks.py writes two more.

    python3 tests/reference/instrument_files.py
"""
import math
import pathlib

PLACE = pathlib.Path(__file__).parent.parent / "data" / "instruments"
TERMS = [(1e-2, 4e7), (1.0, 8e6), (1e2, 2e6)]  # relaxation time [s] and modulus [Pa]
EQUILIBRIUM = 1e6


def shear(frequency, celsius):
    """G' and G'' [Pa] at a frequency [Hz] and a temperature [degC]."""
    omega = 2 * math.pi * frequency * 10 ** (-10 * (celsius - 20) / (100 + celsius - 20))
    storage, loss = EQUILIBRIUM, 0.0
    for tau, modulus in TERMS:
        x = omega * tau
        storage += modulus * x * x / (1 + x * x)
        loss += modulus * x / (1 + x * x)
    return storage, loss


def rows(temperatures, per_decade=4):
    for celsius in temperatures:
        for k in range(-per_decade, per_decade + 1):
            frequency = 10 ** (k / per_decade)
            yield (celsius, frequency, *shear(frequency, celsius))


def write(name, text, encoding="utf-8", newline="\n"):
    PLACE.mkdir(parents=True, exist_ok=True)
    (PLACE / name).write_bytes(text.replace("\n", newline).encode(encoding))


def comma(number, digits=6):
    return f"{number:.{digits}g}".replace(".", ",")


# A rheometer: preamble, names and units in rows of their own, byte order mark, CRLF, columns that do not matter.
text = "Filename,binder 7\nInstrument name,Rheometer\nSample,binder\n\n[step]\nFrequency sweep - 1\n"
text += "Storage modulus G',Loss modulus G'',Tan(delta),Frequency,Temperature,Oscillation torque,Step time\n"
text += "MPa,MPa,,Hz,°C,µN.m,s\n"
for i, (celsius, frequency, storage, loss) in enumerate(rows([10, 20, 30])):
    text += f"{storage / 1e6:.7g},{loss / 1e6:.7g},{loss / storage:.5g},{frequency:.6g},{celsius:.2f},{12.5 + i},{8.0 * i}\n"
write("rheometer.csv", text, "utf-8-sig", "\r\n")

# An analyser in tension: Latin-1, semicolons, decimal commas, names in a comment.
text = "#EXPORTTYPE:;DATA ALL\n#IDENTITY:;binder\n#DECIMAL:;COMMA\n##Temp./°C;Time/min;Freq./Hz;E'/MPa;E\"/MPa;tan d\n"
for i, (celsius, frequency, storage, loss) in enumerate(rows([10, 20, 30])):
    text += f"{comma(celsius)};{comma(0.5 * i)};{comma(frequency)};{comma(3e-6 * storage)};{comma(3e-6 * loss)};{comma(loss / storage)}\n"
write("tension.csv", text, "latin-1", "\r\n")

# A spreadsheet of tabs in UTF-16, with the moduli as M' and M'': which is which has to be told.
text = "Curve Name:\n\tDMA binder\nIndex\tt\tTs\tf\tM'\tM''\n[]\t[s]\t[°C]\t[Hz]\t[MPa]\t[MPa]\n"
for i, (celsius, frequency, storage, loss) in enumerate(rows([20])):
    text += f"{i}\t{4 * i}\t{celsius}\t{frequency:.6g}\t{storage / 1e6:.7g}\t{loss / 1e6:.7g}\n"
write("unicode.txt", text, "utf-16", "\r\n")

# A rheometer of another maker: tabs, angular frequencies, unit row in brackets, Pa with exponents.
text = "Project:\tbinder\nTest:\tFrequency sweep\nInterval data:\tPoint No.\tAngular Frequency\tStorage Modulus\tLoss Modulus\tTemperature\n"
text += "\t\t[rad/s]\t[Pa]\t[Pa]\t[°C]\n"
for i, (celsius, frequency, storage, loss) in enumerate(rows([20, 45])):
    text += f"\t{i + 1}\t{2 * math.pi * frequency:.6E}\t{storage:.6E}\t{loss:.6E}\t{celsius:.1f}\n"
write("sweeps.txt", text)

# A German spreadsheet: decimal commas and names in another language, to be told.
text = "Frequenz [Hz];Speichermodul [MPa];Verlustmodul [MPa];Kommentar\n"
for celsius, frequency, storage, loss in rows([20]):
    text += f"{comma(frequency)};{comma(storage / 1e6)};{comma(loss / 1e6)};gut\n"
write("german.csv", text, "utf-8", "\r\n")

# Asphalt: the absolute value of the complex shear modulus ("dynamic modulus") and the phase angle.
text = "Temp. (°C);Freq. (Hz);|G*| (kPa);Phase angle (°)\n"
for celsius, frequency, storage, loss in rows([10, 20, 30]):
    text += f"{celsius};{frequency:.6g};{math.hypot(storage, loss) / 1e3:.8g};{math.degrees(math.atan2(loss, storage)):.8g}\n"
write("asphalt.csv", text)

# An analyser in bending that gives the storage modulus and the loss factor alone, in units of the United States.
text = "Frequency,Temperature,Flexural Storage Modulus,Tan Delta,Stiffness\nHz,°F,psi,,N/m\n"
for celsius, frequency, storage, loss in rows([20]):
    text += f"{frequency:.6g},{1.8 * celsius + 32:.2f},{3 * storage / 6894.757293168:.8g},{loss / storage:.8g},{storage:.4g}\n"
write("bending.csv", text)

# A rheometer that writes a table for each temperature.
text = "Filename,binder 7\n"
for step, celsius in enumerate([10, 20, 30]):
    text += f"\n[step]\nFrequency sweep - {step + 1}\nAngular frequency,Storage modulus,Loss modulus,Tan(delta),Temperature\n"
    text += "rad/s,Pa,Pa,,°C\n"
    for _, frequency, storage, loss in rows([celsius]):
        text += f"{2 * math.pi * frequency:.7g},{storage:.7g},{loss:.7g},{loss / storage:.5g},{celsius:.2f}\n"
write("steps.csv", text)

# An analyser that aligns its columns by blanks; the index has no unit.
text = "Curve Name:\n  DMA binder\nCurve Values:\n"
text += "".join(f"{name:>14}" for name in ("Index", "Ts", "f", "G'", "G''")) + "\n"
text += "".join(f"{unit:>14}" for unit in ("", "[°C]", "[Hz]", "[MPa]", "[MPa]")) + "\n"
for i, (celsius, frequency, storage, loss) in enumerate(rows([10, 20, 30])):
    text += f"{i:14d}{celsius:14.2f}{frequency:14.6g}{storage / 1e6:14.7g}{loss / 1e6:14.7g}\n"
write("aligned.txt", text)

# A ramp of temperature, 0.3 K from row to row, while three frequencies alternate.
text = "Temperature [°C],Frequency [Hz],G' [MPa],G'' [MPa]\n"
for i in range(121):
    celsius, frequency = 5 + 0.3 * i, (0.3, 3.0, 30.0)[i % 3]
    storage, loss = shear(frequency, celsius)
    text += f"{celsius:.2f},{frequency:g},{storage / 1e6:.7g},{loss / 1e6:.7g}\n"
write("ramp.csv", text)

# Not sound: every comma may part thousands.
text = "Frequency [Hz];Storage modulus [kPa];Loss modulus [kPa]\n"
for number in (1, 2, 3, 4):
    text += f"{number};{number},234;{number},111\n"
write("broken-thousands.csv", text)

# Not sound: a phase angle of noise beyond 90 degrees, and one of zero.
text = "Frequency [Hz],|E*| [MPa],Phase angle [deg]\n1,12.5,4.1\n2,13.0,93.2\n4,14.1,0\n8,15,3.2\n"
write("broken-phase.csv", text)

# Not sound: texts and values below zero among the numbers, and a row that breaks off.
text = "Frequency [Hz],Storage modulus [MPa],Loss modulus [MPa]\n1,12.5,overload\n2,13.0,---\n4,14.1,2.2\n8,15\n"
write("broken-values.csv", text)
text = "Frequency [Hz],Storage modulus [MPa],Loss modulus [MPa]\n1,12.5,-0.1\n2,13.0,0.2\n4,0,2.2\n8,15,2\n"
write("broken-signs.csv", text)

# Not sound: a workbook that was given the name of a table.
(PLACE / "broken-workbook.csv").write_bytes(b"PK\x03\x04\x14\x00\x06\x00\x08\x00\x00\x00!\x00")
