// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

namespace tests {

/// A row of test data for each entry of a table, by its name; `QFETCH(int, row)` gives its index.
template <class Table>
void addRows(const Table &table)
{
    QTest::addColumn<int>("row");
    for (std::size_t i = 0; i < table.size(); ++i)
        QTest::newRow(table[i].name.c_str()) << int(i);
}

} // namespace tests
