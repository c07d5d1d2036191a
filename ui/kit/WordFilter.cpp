// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/WordFilter.h"

#include "ui/text/Search.h"

namespace ui::kit {

void WordFilter::setWords(const QString& words)
{
    m_words = text::plain(words.trimmed());
    invalidateFilter();
}

bool WordFilter::filterAcceptsRow(int row, const QModelIndex& parent) const
{
    if (m_words.isEmpty())
        return true;
    for (int column = 0; column < sourceModel()->columnCount(parent); ++column)
        if (text::plain(sourceModel()->index(row, column, parent).data().toString()).contains(m_words))
            return true;
    return false;
}

}  // namespace ui::kit
