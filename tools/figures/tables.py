# SPDX-License-Identifier: MIT
"""Tables of the measurements: CSV files with a heading."""

import csv

import numpy


class Table:
    """The rows of a file, or some of them."""

    def __init__(self, rows):
        self.rows = rows

    def __getitem__(self, column):
        """The numbers of a column."""
        return numpy.array([float(row[column]) for row in self.rows])

    def words(self, column):
        return [row[column] for row in self.rows]

    def where(self, **cells):
        """The rows that have these words, or numbers, in these columns."""
        return Table([row for row in self.rows if all(_same(row[name], cell) for name, cell in cells.items())])

    def __len__(self):
        return len(self.rows)


def _same(word, cell):
    return word == cell if isinstance(cell, str) else float(word) == cell


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return Table(list(csv.DictReader(file)))


def write(path, headings, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(headings)
        writer.writerows(rows)


def pareto_front(seconds, errors, rivals=None, nothing=0.0, same_time=0.0):
    """Which points no rival beats: none is at least as good in both ways and better in one.

    Errors below `nothing` are equal, and so are times that differ by less than the share `same_time`.
    Points compete with those that have the same word in `rivals`."""
    errors = numpy.maximum(errors, nothing)
    front = []
    for k, (time, error) in enumerate(zip(seconds, errors)):
        beaten = any((seconds[j] < (1 - same_time) * time and errors[j] <= error)
                     or (seconds[j] <= time and errors[j] < error)
                     for j in range(len(seconds)) if rivals is None or rivals[j] == rivals[k])
        front.append(bool(numpy.isfinite(error)) and not beaten)
    return numpy.array(front)
