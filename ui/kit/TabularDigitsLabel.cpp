// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/TabularDigitsLabel.h"

#include <algorithm>

#include <QPainter>

#include "ui/kit/Theme.h"

namespace ui::kit {
namespace {

int digitWidth(const QFontMetrics& metrics)
{
    int widest = 0;
    for (char16_t digit = u'0'; digit <= u'9'; ++digit)
        widest = std::max(widest, metrics.horizontalAdvance(QChar(digit)));
    return widest;
}

}  // namespace

TabularDigitsLabel::TabularDigitsLabel(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void TabularDigitsLabel::setText(const QString& text, const QString& unit)
{
    if (text == m_text && unit == m_unit)
        return;
    const QSize before = sizeHint();
    m_text = text;
    m_unit = unit;
    if (sizeHint() != before)
        updateGeometry();
    update();
}

void TabularDigitsLabel::setColour(const QColor& colour)
{
    if (colour == m_colour)
        return;
    m_colour = colour;
    update();
}

QFont TabularDigitsLabel::unitFont() const
{
    QFont smaller = font();
    smaller.setPixelSize(std::clamp(font().pixelSize() * 5 / 9, kSmall, kTitle));
    smaller.setWeight(QFont::Normal);
    return smaller;
}

int TabularDigitsLabel::figureWidth() const
{
    const QFontMetrics metrics(font());
    const int digit = digitWidth(metrics);
    int width = 0;
    for (const QChar c : m_text)
        width += c.isDigit() ? digit : metrics.horizontalAdvance(c);
    return width;
}

int TabularDigitsLabel::unitWidth() const
{
    return m_unit.isEmpty() ? 0 : kSpace1 + QFontMetrics(unitFont()).horizontalAdvance(m_unit);
}

QSize TabularDigitsLabel::sizeHint() const
{
    return {figureWidth() + unitWidth() + 2, QFontMetrics(font()).height()};
}

void TabularDigitsLabel::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setFont(font());
    painter.setPen(m_colour.isValid() ? m_colour : palette().color(QPalette::WindowText));
    const QFontMetrics metrics(font());
    const int digit = digitWidth(metrics);
    const int free = width() - figureWidth() - unitWidth();
    int x = 0;
    if ((m_alignment & Qt::AlignRight) != 0)
        x = free;
    else if ((m_alignment & Qt::AlignHCenter) != 0)
        x = free / 2;
    const int baseline = (height() - metrics.height()) / 2 + metrics.ascent();
    for (const QChar c : m_text) {
        const int own = metrics.horizontalAdvance(c);
        const int cell = c.isDigit() ? digit : own;
        painter.drawText(x + (cell - own) / 2, baseline, QString(c));
        x += cell;
    }
    if (m_unit.isEmpty())
        return;
    painter.setFont(unitFont());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(x + kSpace1, baseline, m_unit);
}

}  // namespace ui::kit
