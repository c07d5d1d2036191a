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

/// The page on which another tooth is chosen: the arches, what is chosen in words, and the way to a scan of one's own.
class ToothChooser : public kit::Page
{
    Q_OBJECT
public:
    ToothChooser(const kit::Actions& actions, QWidget* parent);

    /// The tooth now on the table; 0 for a scan without a number.
    void setPresent(int fdi);
    /// The whole mouth in space in place of the flat arches. Only where Mouth::isPossible().
    void showMouth(bool inSpace);
    /// Reduced motion.
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
    QSpacerItem* m_gap;  ///< between picture and words
    ArchView* m_arches;
    Mouth* m_mouth = nullptr;  ///< from when it is first asked for
    QLabel* m_number;
    QLabel* m_name;
    QLabel* m_note;
    QPushButton* m_take;
    QPushButton* m_other;  ///< from the flat arches to the mouth and back
    int m_present = 0;
    bool m_mouthShown = false;
    bool m_movesLittle = false;
};

}  // namespace ui::toothchooser
