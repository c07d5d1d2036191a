// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

#include "lessons/PresetFile.h"
#include "ui/kit/Page.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;
class QStackedWidget;
class QVBoxLayout;

namespace ui::presets {

class FeedChart;
class PresetTable;
class SimplePanel;

/// The hardness presets there are, each in all its versions, and one of them to be looked at, tried, turned and kept as
/// another version. Whatever is asked of files and of the servo goes out by signals.
class PresetsPage : public kit::Page
{
    Q_OBJECT
public:
    PresetsPage(const kit::Actions& actions, QWidget* parent);

    /// What is on the shelf. What is being turned stays.
    void setPresets(std::vector<lessons::ReadPreset> all, const core::settings::FeelPreset& inUse);
    /// Shows this version, unless another one is being changed.
    void select(const core::settings::FeelPreset& preset);
    /// Takes over what was turned while it was tried: the version on the page, or what was loaded in the console.
    void setDraft(const core::settings::FeelPreset& preset);
    /// What could not be done, beside the buttons, a second line of it quieter; empty: nothing any more.
    void setFault(const QString& sentence);

    /// Whether the user may save and import versions and put them to use; else they may look at them and try them.
    void setMayKeep(bool may);

    /// The school's presets can be retired, and are seen when they are.
    void setMayRetire(bool may);

    /// Describes a preset that the user has changed, and may save, and has not. Empty: there is none.
    [[nodiscard]] QString unsavedChanges() const;
    /// Shows the version that is in use.
    void discardChanges();

    [[nodiscard]] const core::settings::FeelPreset& draft() const { return m_draft; }
    [[nodiscard]] const std::vector<lessons::ReadPreset>& all() const { return m_all; }

signals:
    /// A preset that is perhaps not kept yet, and the version that it was made of.
    void tryRequested(const core::settings::FeelPreset& base, const core::settings::FeelPreset& preset);
    void compareRequested(const core::settings::FeelPreset& first, const core::settings::FeelPreset& second,
                          int trials);
    /// As another version of its name.
    void saveRequested(const core::settings::FeelPreset& preset);
    /// Teeth are to feel like this from now on, unless a lesson says otherwise.
    void useRequested(const core::settings::FeelPreset& preset);
    /// A preset in all its versions is to be offered to nobody any more, or again.
    void retireRequested(const QString& name, bool isRetired);
    void importRequested();
    void exportRequested(const core::settings::FeelPreset& preset);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeList();
    QWidget* makeDetails();
    QWidget* makePreset(QWidget* parent);
    void addHead(QVBoxLayout* column, QWidget* side);
    void addNumbers(QVBoxLayout* column, QWidget* side);
    QWidget* makeCompare(QWidget* parent);
    void fit();
    void fill();
    void show(const core::settings::FeelPreset& preset);
    void write(const core::settings::FeelPreset& draft);
    void take(const core::settings::FeelPreset& preset);
    void tell();
    void choose(const core::settings::FeelPreset& preset);
    void markShown();
    [[nodiscard]] QString changedWords() const;
    void offerOther();
    void duplicate();
    [[nodiscard]] bool isChanged() const;
    [[nodiscard]] bool isNewest() const;
    [[nodiscard]] bool isRetired() const;
    [[nodiscard]] bool mayBeRetired() const;
    [[nodiscard]] std::vector<core::settings::FeelPreset> origins() const;

    std::vector<lessons::ReadPreset> m_all;
    core::settings::FeelPreset m_inUse;
    core::settings::FeelPreset m_base;   ///< the version that is chosen in the list
    core::settings::FeelPreset m_draft;  ///< what has been made of it

    bool m_mayKeep = true;
    bool m_mayRetire = false;
    bool m_otherIsChosen = false;  ///< what to compare with, by hand

    QWidget* m_side = nullptr;  ///< with the list
    QListWidget* m_list = nullptr;
    QLineEdit* m_name = nullptr;
    QLineEdit* m_notes = nullptr;
    QLabel* m_version = nullptr;
    QStackedWidget* m_ways = nullptr;
    SimplePanel* m_simple = nullptr;
    PresetTable* m_table = nullptr;
    FeedChart* m_chart = nullptr;
    QBoxLayout* m_middle = nullptr;  ///< with the numbers and the chart
    QLabel* m_bound = nullptr;
    QLabel* m_fault = nullptr;
    QLabel* m_faultDetail = nullptr;
    QComboBox* m_other = nullptr;
    QSpinBox* m_trials = nullptr;
    QPushButton* m_compare = nullptr;
    QPushButton* m_try = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_use = nullptr;
    QPushButton* m_import = nullptr;
    QPushButton* m_export = nullptr;
    QPushButton* m_retire = nullptr;
};

}  // namespace ui::presets
