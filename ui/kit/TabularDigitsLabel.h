// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace ui::kit {

/// A one-line label in which every digit has the width of the widest, so that a changing number does not move. (Qt 6.4
/// cannot request the tabular digits of a font.)
class TabularDigitsLabel : public QWidget
{
    Q_OBJECT
public:
    explicit TabularDigitsLabel(QWidget* parent = nullptr);

    [[nodiscard]] QString text() const { return m_text; }
    [[nodiscard]] QString unit() const { return m_unit; }
    /// @param unit  shown after the number, smaller and paler
    void setText(const QString& text, const QString& unit = {});
    void setColour(const QColor& colour);  ///< invalid: the text colour of the palette
    void setAlignment(Qt::Alignment alignment) { m_alignment = alignment; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QFont unitFont() const;
    [[nodiscard]] int figureWidth() const;
    [[nodiscard]] int unitWidth() const;

    QString m_text;
    QString m_unit;
    QColor m_colour;
    Qt::Alignment m_alignment = Qt::AlignLeft;
};

}  // namespace ui::kit
