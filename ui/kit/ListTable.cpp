// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/ListTable.h"

#include <algorithm>

#include <QAbstractButton>
#include <QHeaderView>
#include <QKeyEvent>
#include <QStyleOptionHeader>

#include "ui/kit/Accessibility.h"
#include "ui/text/EveryLanguage.h"

namespace ui::kit {
namespace {

constexpr int kListRowPx = 34;

/// A header that shows the sorting arrow as part of the text, to the left of right-aligned text. Qt's own arrow would
/// cover the last letters.
class Heads final : public QHeaderView
{
public:
    explicit Heads(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) { setSectionsClickable(true); }

protected:
    void initStyleOptionForIndex(QStyleOptionHeader* option, int logicalIndex) const override
    {
        QHeaderView::initStyleOptionForIndex(option, logicalIndex);
        if (option->sortIndicator == QStyleOptionHeader::None || option->text.isEmpty())
            return;
        // Qt calls ascending order SortDown.
        const QChar arrow = option->sortIndicator == QStyleOptionHeader::SortDown ? QChar(0x2191) : QChar(0x2193);
        option->sortIndicator = QStyleOptionHeader::None;
        option->text = option->textAlignment.testFlag(Qt::AlignRight) ? arrow + QStringLiteral(" ") + option->text
                                                                      : option->text + QStringLiteral(" ") + arrow;
    }
};

}  // namespace

ListTable::ListTable(QWidget* parent) : QTableView(parent)
{
    setProperty("kind", "list");
    setHorizontalHeader(new Heads(this));
    setSortingEnabled(true);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setShowGrid(false);
    setWordWrap(false);
    setTabKeyNavigation(false);
    setCornerButtonEnabled(false);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(kListRowPx);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);  // above the text of the cells
    verticalHeader()->setHighlightSections(false);
    // Shows the first rows after sorting.
    connect(horizontalHeader(), &QHeaderView::sortIndicatorChanged, this, &QTableView::scrollToTop);
    connect(horizontalHeader(), &QHeaderView::sortIndicatorChanged, this, &ListTable::describeSorting);
    text::bindTranslation(this, [this] {
        describeSorting();
        for (auto* corner : findChildren<QAbstractButton*>(QString(), Qt::FindDirectChildrenOnly))
            corner->setAccessibleName(tr("Corner of the table"));
    });
}

/// Sets the model. Its headings may be retranslated after everything else.
void ListTable::setModel(QAbstractItemModel* model)
{
    QTableView::setModel(model);
    if (model != nullptr)
        connect(model, &QAbstractItemModel::headerDataChanged, this, &ListTable::describeSorting);
    describeSorting();
}

bool ListTable::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Home:
        case Qt::Key_End:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
        case Qt::Key_Space:
        case Qt::Key_Return:
        case Qt::Key_Enter:
            event->accept();
            return true;
        default:
            break;
        }
    }
    return QTableView::event(event);
}

void ListTable::describeSorting()
{
    const QHeaderView* heads = horizontalHeader();
    const int column = heads->sortIndicatorSection();
    if (model() == nullptr || !isSortingEnabled() || column < 0 || column >= heads->count()) {
        setAccessibleDescription({});
        return;
    }
    const QString words = model()->headerData(column, Qt::Horizontal).toString().simplified();
    //: %1: a heading
    setAccessibleDescription((heads->sortIndicatorOrder() == Qt::AscendingOrder ? tr("Sorted by: %1, from the least")
                                                                                : tr("Sorted by: %1, from the most"))
                                 .arg(words));
}

void ListTable::sortBeside(int columns)
{
    const QHeaderView* heads = horizontalHeader();
    int place = heads->isSortIndicatorShown() ? heads->visualIndex(heads->sortIndicatorSection()) : -1;
    do
        place += columns;
    while (place >= 0 && place < heads->count() && heads->isSectionHidden(heads->logicalIndex(place)));
    // Moving left from the first heading clears the sorting, if a click on a heading can clear it, too.
    if (place < 0 && heads->isSortIndicatorClearable())
        sortByColumn(-1, Qt::AscendingOrder);
    else if (place < 0 || place >= heads->count())
        return;
    else
        sortByColumn(heads->logicalIndex(place), heads->sortIndicatorOrder());
    if (place >= 0)
        scrollTo(model()->index(0, heads->logicalIndex(place)));
    announce(*this);
}

void ListTable::keyPressEvent(QKeyEvent* event)
{
    if (event->modifiers() == Qt::AltModifier && isSortingEnabled()) {
        const int key = event->key();
        if (key == Qt::Key_Left || key == Qt::Key_Right) {
            sortBeside(key == Qt::Key_Left ? -1 : 1);
            return;
        }
        if (key == Qt::Key_Up || key == Qt::Key_Down) {
            sortByColumn(std::max(0, horizontalHeader()->sortIndicatorSection()),
                         key == Qt::Key_Up ? Qt::AscendingOrder : Qt::DescendingOrder);
            announce(*this);
            return;
        }
    }
    m_isByKey = true;
    if (event->key() == Qt::Key_Space && currentIndex().isValid())
        emit activated(currentIndex());
    else
        QTableView::keyPressEvent(event);
    m_isByKey = false;
}

}  // namespace ui::kit
