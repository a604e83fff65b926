#!/usr/bin/env python3
"""Labels the pixels of a grey picture of two phases: takes the median of each pixel and its eight neighbours, which
removes noise, and calls the pixel 255 if that is brighter than a threshold, 0 if not.

  examples/image/threshold.py IN.png OUT.png THRESHOLD
"""

import sys

import grey_png


def main():
    source, target, threshold = sys.argv[1], sys.argv[2], float(sys.argv[3])
    rows = grey_png.read(source)
    last_row, last_column = len(rows) - 1, len(rows[0]) - 1
    labels, bright = [], 0
    for row in range(last_row + 1):
        around = [rows[min(max(row + d, 0), last_row)] for d in (-1, 0, 1)]
        line = []
        for column in range(last_column + 1):
            columns = [min(max(column + d, 0), last_column) for d in (-1, 0, 1)]
            median = sorted(one[c] for one in around for c in columns)[4]
            line.append(255 if median > threshold else 0)
        labels.append(line)
        bright += line.count(255)
    grey_png.write(target, labels)
    print(f"{target}: {100.0 * bright / (len(rows) * len(rows[0])):.1f} % of the pixels are brighter than {threshold:g}")


if __name__ == "__main__":
    main()
