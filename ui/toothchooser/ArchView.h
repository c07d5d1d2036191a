// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QList>
#include <QPainterPath>
#include <QWidget>

namespace ui::toothchooser {

/// One tooth of the arches, for keyboard and screen reader. It paints nothing; ArchView paints the tooth and its focus.
class ArchTooth : public QAbstractButton
{
    Q_OBJECT
public:
    ArchTooth(int fdi, QWidget* parent);
    [[nodiscard]] int fdi() const { return m_fdi; }

protected:
    void paintEvent(QPaintEvent*) override {}

private:
    int m_fdi;
};

/// Both arches from above, as a dentist sees the patient. Teeth of the left half can be selected by hovering, clicking
/// and the arrow keys. The right half is drawn faintly for orientation.
class ArchView : public QWidget
{
    Q_OBJECT
public:
    explicit ArchView(QWidget* parent);

    void setSelected(int fdi);  ///< 0: none
    [[nodiscard]] int selected() const { return m_selected; }
    /// Sets the focus to the selected tooth, or to the first one if none is selected.
    void takeFocus();
    [[nodiscard]] QSize sizeHint() const override { return {400, 640}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {260, 420}; }

signals:
    void selectionChanged(int fdi);
    /// Emitted on a double click or Enter.
    void toothActivated(int fdi);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Tooth
    {
        int fdi = 0;
        QPainterPath outline;  ///< widget coordinates
        QPainterPath grooves;
        QPointF centre;
        QPointF label;
        ArchTooth* button = nullptr;  ///< null in the right half
    };
    void layOut();
    [[nodiscard]] const Tooth* toothAt(QPointF where) const;
    [[nodiscard]] const Tooth* toothOf(int fdi) const;
    void select(int fdi);

    QList<Tooth> m_teeth;
    double m_pxPerMm = 1.0;
    int m_selected = 0;
    int m_hovered = 0;
};

}  // namespace ui::toothchooser
