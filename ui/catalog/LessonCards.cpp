// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/catalog/LessonCards.h"

#include <utility>

#include <QCoreApplication>
#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

#include "ui/catalog/LessonScene.h"
#include "ui/catalog/LessonThumbs.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/Theme.h"
#include "ui/text/LessonTexts.h"

namespace ui::catalog {
namespace {

using namespace ui::kit;

constexpr int kCardPx = 208;
constexpr int kPicturePx = 138;
constexpr int kCardHeadPx = 36;
constexpr int kPadPx = 10;
constexpr int kAboveWordsPx = 6;
constexpr int kBelowWordsPx = 8;
constexpr double kCardEdgePx = 1.5;
constexpr int kCardIconPx = 40;
constexpr int kTitleLines = 2;
constexpr QRgb kOnPicture = 0xFFE8EDED;

QFont titleFont()
{
    return typeface(kBody, QFont::Medium);
}

/// Wraps the title to the width of a card. Elides the last line if there are too many.
QStringList titleLines(const QString& title)
{
    const double wide = kCardPx - 2.0 * (kCardEdgePx + kPadPx);
    QTextLayout layout(title, titleFont());
    layout.beginLayout();
    QStringList lines;
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(wide);
        if (lines.size() == kTitleLines - 1) {
            lines << QFontMetrics(titleFont())
                         .elidedText(title.mid(line.textStart()), Qt::ElideRight, static_cast<int>(wide));
            break;
        }
        lines << title.mid(line.textStart(), line.textLength()).trimmed();
    }
    layout.endLayout();
    return lines;
}

}  // namespace

LessonCards::LessonCards(LessonThumbs& thumbs, std::function<const ::lessons::Lesson*(int)> lessonOf, QListView* view)
    : QStyledItemDelegate(view), m_thumbs(thumbs), m_lessonOf(std::move(lessonOf)), m_view(view)
{}

QSize LessonCards::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const
{
    if (index.data(CardEntry).isValid()) {
        // Height for the title, the tooth, and the class if the lesson is assigned.
        const auto titles = static_cast<int>(titleLines(index.data(Qt::DisplayRole).toString()).size());
        const int others = index.data(CardDue).toString().isEmpty() ? 1 : 2;
        return {kCardPx, kPicturePx + kAboveWordsPx + titles * QFontMetrics(titleFont()).height() +
                             others * QFontMetrics(typeface(kSmall)).height() + kBelowWordsPx +
                             static_cast<int>(2.0 * kCardEdgePx)};
    }
    return {m_view->viewport()->width() - 2 * m_view->spacing() - 1, kCardHeadPx};
}

void LessonCards::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (index.data(CardEntry).isValid()) {
        paintCard(*painter, option, index);
    } else {
        painter->setFont(typeface(kBody, QFont::DemiBold));
        painter->setPen(option.palette.color(QPalette::PlaceholderText));
        painter->drawText(option.rect.adjusted(2, 0, 0, -kSpace1), Qt::AlignLeft | Qt::AlignBottom,
                          index.data(Qt::DisplayRole).toString());
    }
    painter->restore();
}

/// Paints the tooth of a lesson, or an icon if it has no picture. A null lesson is an invalid file.
void LessonCards::paintPicture(QPainter& painter, const QRectF& picture, const QPainterPath& shape,
                               const ::lessons::Lesson* lesson) const
{
    painter.save();
    painter.setClipPath(shape);
    painter.fillRect(picture, QColor(kPictureGround));
    const double ratio = painter.device()->devicePixelRatioF();
    if (lesson != nullptr && isPictured(*lesson)) {
        if (const QPixmap made = m_thumbs.picture(*lesson, picture.size().toSize(), ratio); !made.isNull())
            painter.drawPixmap(picture.topLeft(), made);
    } else {
        const QPixmap icon = linePixmap(lesson == nullptr ? QStringLiteral("warning") : QStringLiteral("hand"),
                                        QColor(kOnPicture), kCardIconPx, ratio);
        painter.drawPixmap(QPointF(picture.center().x() - 0.5 * kCardIconPx, picture.center().y() - 0.5 * kCardIconPx),
                           icon);
    }
    painter.restore();
}

void LessonCards::paintCard(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const QPalette palette = m_view->parentWidget()->palette();  // the view's own has no background
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    const bool isHovered = option.state.testFlag(QStyle::State_MouseOver);
    const QRectF card = QRectF(option.rect).adjusted(kCardEdgePx, kCardEdgePx, -kCardEdgePx, -kCardEdgePx);
    QPainterPath shape;
    shape.addRoundedRect(card, kRadius, kRadius);
    painter.fillPath(shape, palette.color(isHovered || isSelected ? QPalette::Midlight : QPalette::Base));
    const QRectF picture(card.left(), card.top(), card.width(), kPicturePx);
    paintPicture(painter, picture, shape, m_lessonOf(index.data(CardEntry).toInt()));
    painter.setFont(typeface(kSmall, QFont::DemiBold));
    constexpr double kPillPx = 20.0;
    const auto pill = [&](const QString& words, bool left, bool below = false) {
        const double wide = painter.fontMetrics().horizontalAdvance(words) + 12.0;
        const QRectF place(left ? picture.left() + 6.0 : picture.right() - 6.0 - wide,
                           below ? picture.bottom() - 6.0 - kPillPx : picture.top() + 6.0, wide, kPillPx);
        QPainterPath path;
        path.addRoundedRect(place, 10.0, 10.0);
        painter.fillPath(path, QColor(0x15, 0x18, 0x1A, 0xD0));
        painter.setPen(QColor(kOnPicture));
        painter.drawText(place, Qt::AlignCenter, words);
    };
    if (index.data(CardIsExam).toBool())
        //: On the card of a lesson
        pill(QCoreApplication::translate("Lesson", "exam"), true);
    if (index.data(CardMarked).toBool())
        //: On the card of the lesson that is being worked on
        pill(QCoreApplication::translate("Lesson", "in progress"), false);

    if (index.data(CardIsUsedUp).toBool())
        //: On the card of a lesson
        pill(QCoreApplication::translate("Lesson", "no attempts left"), true, true);

    const QRectF words = card.adjusted(kPadPx, kPicturePx + kAboveWordsPx, -kPadPx, -kBelowWordsPx);
    painter.setFont(titleFont());
    painter.setPen(palette.color(QPalette::WindowText));
    double high = 0.0;
    for (const QString& line : titleLines(index.data(Qt::DisplayRole).toString())) {
        painter.drawText(words.adjusted(0.0, high, 0.0, 0.0), Qt::AlignLeft | Qt::AlignTop, line);
        high += painter.fontMetrics().height();
    }
    const QString score = index.data(CardScore).toString();
    painter.setFont(typeface(kBody, QFont::DemiBold));
    const int scoreWidth = score.isEmpty() ? 0 : painter.fontMetrics().horizontalAdvance(score) + kSpace2;
    const Tones tone = tones(palette);
    painter.setPen(index.data(CardPassed).toBool() ? palette.color(QPalette::Link) : tone.attentionText);
    painter.drawText(words, Qt::AlignRight | Qt::AlignBottom, score);
    painter.setFont(typeface(kSmall));
    painter.setPen(palette.color(QPalette::PlaceholderText));
    const QString due = index.data(CardDue).toString();
    const double besideScore = words.width() - scoreWidth;
    painter.drawText(words.adjusted(0.0, high, 0.0, 0.0), Qt::AlignLeft | Qt::AlignTop,
                     text::shortTooth(index.data(CardTooth).toString(), painter.fontMetrics(),
                                      static_cast<int>(due.isEmpty() ? besideScore : words.width())));
    painter.setFont(typeface(kSmall, QFont::Medium));
    painter.setPen(index.data(CardIsLate).toBool() ? tone.harmText : palette.color(QPalette::WindowText));
    painter.drawText(words, Qt::AlignLeft | Qt::AlignBottom,
                     painter.fontMetrics().elidedText(due, Qt::ElideRight, static_cast<int>(besideScore)));
    painter.setBrush(Qt::NoBrush);
    const bool hasKeys = option.state.testFlag(QStyle::State_HasFocus);
    painter.setPen(hasKeys      ? QPen(palette.color(QPalette::Link), 3.0)
                   : isSelected ? QPen(palette.color(QPalette::PlaceholderText), 2.0)
                                : QPen(palette.color(QPalette::Mid), 1.0));
    painter.drawPath(shape);
}

}  // namespace ui::catalog
