// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/HandList.h"

#include <algorithm>

#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

constexpr int kHandRowPx = 76;
constexpr int kSignPx = 22;
constexpr int kBarPx = 3;
constexpr int kApartPx = 2 * kSpace2;

class HandRow final : public QStyledItemDelegate
{
public:
    explicit HandRow(HandList* list) : QStyledItemDelegate(list), m_list(list) {}

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const override
    {
        return {kHandRowPx, kHandRowPx + (m_list->rows().at(index.row()).isApart ? kApartPx : 0)};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const HandList::Row& row = m_list->rows().at(index.row());
        // The list's own Base is transparent.
        const QPalette& palette = m_list->parentWidget()->palette();
        const bool isSelected = option.state.testFlag(QStyle::State_Selected);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const QRect whole = option.rect.adjusted(0, row.isApart ? kApartPx : 0, 0, 0);
        if (row.isApart) {
            const double y = option.rect.top() + 0.5 * kApartPx;
            painter->setPen(palette.color(QPalette::Mid));
            painter->drawLine(QPointF(whole.left() + 2.0, y), QPointF(whole.right() - 2.0, y));
        }
        const QRectF card = QRectF(whole).adjusted(2, 2, -2, -2);
        const bool hasFocus = isSelected && m_list->hasFocus();
        painter->setBrush(palette.color(isSelected ? QPalette::Midlight : QPalette::Base));
        painter->setPen(QPen(palette.color(hasFocus ? QPalette::Link : QPalette::Mid), hasFocus ? 2.0 : 1.0));
        painter->drawRoundedRect(card, kRadius, kRadius);
        if (isSelected)
            painter->fillRect(QRectF(card.left(), card.top() + kRadius, kBarPx, card.height() - 2 * kRadius),
                              palette.color(QPalette::Link));
        const QRect inner = whole.adjusted(kSpace4, kSpace2 + 2, -kSpace4, -kSpace2);
        painter->drawPixmap(inner.topLeft(), signPixmap(row.sign, palette, kSignPx, m_list->devicePixelRatioF()));
        const QRect words = inner.adjusted(kSignPx + kSpace2, 0, 0, 0);
        const QString mark = row.isChosen ? HandList::tr("Chosen") : QString();
        painter->setFont(typeface(kSmall, QFont::DemiBold));
        const int markPx = mark.isEmpty() ? 0 : painter->fontMetrics().horizontalAdvance(mark) + kSpace2;
        painter->setPen(palette.color(QPalette::Link));
        painter->drawText(words.adjusted(0, 3, 0, 0), Qt::AlignRight | Qt::AlignTop, mark);
        painter->setFont(typeface(kBody, QFont::DemiBold));
        painter->setPen(palette.color(QPalette::WindowText));
        painter->drawText(words.adjusted(0, 1, -markPx, 0), Qt::AlignLeft | Qt::AlignTop,
                          painter->fontMetrics().elidedText(row.name, Qt::ElideRight, words.width() - markPx));
        painter->setFont(typeface(kSmall));
        // Placeholder colour on a selected row would have too little contrast.
        painter->setPen(palette.color(isSelected ? QPalette::WindowText : QPalette::PlaceholderText));
        painter->drawText(words.adjusted(0, kBody + kSpace2, 0, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                          row.state);
        painter->restore();
    }

private:
    HandList* m_list;
};

}  // namespace

HandList::HandList(QWidget* parent) : QListWidget(parent)
{
    setProperty("kind", "plain");
    setObjectName(QStringLiteral("hands"));
    setItemDelegate(new HandRow(this));
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
    setSpacing(kSpace1 / 2);
    text::bindTranslation(this, [this] { setAccessibleName(tr("Devices")); });
}

void HandList::setRows(const QList<Row>& rows)
{
    if (rows == m_rows)
        return;
    m_rows = rows;
    const QSignalBlocker silent(this);
    while (count() > m_rows.size())
        delete takeItem(count() - 1);
    while (count() < m_rows.size())
        addItem(new QListWidgetItem);
    scheduleDelayedItemsLayout();  // another row may have a gap above it
    for (int k = 0; k < count(); ++k) {
        const Row& row = m_rows.at(k);
        const QString name = row.isChosen ? tr("%1, chosen").arg(row.name) : row.name;
        item(k)->setData(Qt::AccessibleTextRole, QStringLiteral("%1. %2").arg(name, row.state));
        item(k)->setToolTip(row.state);
    }
    if (currentRow() < 0 && count() > 0)
        setCurrentRow(0);
    viewport()->update();
}

void HandList::selectHand(const QString& id)
{
    const auto found = std::find_if(m_rows.begin(), m_rows.end(), [&](const Row& row) { return row.id == id; });
    if (found != m_rows.end())
        setCurrentRow(static_cast<int>(found - m_rows.begin()));
}

QString HandList::selectedHand() const
{
    return currentRow() < 0 ? QString() : m_rows.at(currentRow()).id;
}

}  // namespace ui::devices
