// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/Page.h"

class QHBoxLayout;
class QPushButton;
class QSpacerItem;
class QStackedWidget;

namespace ui::toothchooser {

class ArchView;
class Mouth;

/// The page for choosing another tooth: the arches, the name of the selected tooth, and a button that opens a scan.
class ToothChooser : public kit::Page
{
    Q_OBJECT
public:
    ToothChooser(const kit::Actions& actions, QWidget* parent);

    /// Sets the current tooth. 0: a scan without a number.
    void setPresent(int fdi);
    /// Shows the mouth in 3D instead of the flat arches. Call only if Mouth::isPossible().
    void showMouth(bool inSpace);
    /// Sets reduced motion: no animations.
    void setMovesLittle(bool little);
    [[nodiscard]] bool isMouthShown() const { return m_mouthShown; }

signals:
    void toothChosen(int fdi);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void describe(int fdi);
    void takeFocus();
    void sayOther();

    QStackedWidget* m_pictures;
    QHBoxLayout* m_row;
    QSpacerItem* m_gap;  ///< between picture and text
    ArchView* m_arches;
    Mouth* m_mouth = nullptr;  ///< null until needed
    QLabel* m_number;
    QLabel* m_name;
    QLabel* m_note;
    QPushButton* m_take;
    QPushButton* m_other;  ///< switches between the flat arches and the mouth
    int m_present = 0;
    bool m_mouthShown = false;
    bool m_movesLittle = false;
};

}  // namespace ui::toothchooser
