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

/// The page of hardness presets with all their versions. A preset can be viewed, tried, changed and saved as a new
/// version. The page emits a signal for every access to files and to the servo.
class PresetsPage : public kit::Page
{
    Q_OBJECT
public:
    PresetsPage(const kit::Actions& actions, QWidget* parent);

    /// Sets the stored presets. Keeps unsaved changes.
    void setPresets(std::vector<lessons::ReadPreset> all, const core::settings::FeelPreset& inUse);
    /// Shows a version, unless the user has unsaved changes to another.
    void select(const core::settings::FeelPreset& preset);
    /// Applies the changes made in a trial, or the preset that the console loaded.
    void setDraft(const core::settings::FeelPreset& preset);
    /// Shows an error beside the buttons, with its second line in smaller type. Empty: no error.
    void setFault(const QString& sentence);

    /// Sets whether the user may save and import versions and put them into use. If not, the page is read-only, except
    /// for trials.
    void setMayKeep(bool may);

    /// Sets whether the user may retire presets and can see retired ones.
    void setMayRetire(bool may);

    /// Returns a description of the unsaved changes, if the user may save them. Empty if there are none.
    [[nodiscard]] QString unsavedChanges() const;
    /// Discards the changes and shows the version in use.
    void discardChanges();

    [[nodiscard]] const core::settings::FeelPreset& draft() const { return m_draft; }
    [[nodiscard]] const std::vector<lessons::ReadPreset>& all() const { return m_all; }

signals:
    /// Emitted when the user requests a trial of a preset, which may be unsaved, with the version that it is based on.
    void tryRequested(const core::settings::FeelPreset& base, const core::settings::FeelPreset& preset);
    void compareRequested(const core::settings::FeelPreset& first, const core::settings::FeelPreset& second,
                          int trials);
    /// Emitted when the user requests to save a new version under the preset's name.
    void saveRequested(const core::settings::FeelPreset& preset);
    /// Emitted when the user puts a preset into use for all teeth whose lesson has no preset of its own.
    void useRequested(const core::settings::FeelPreset& preset);
    /// Emitted when the user requests to retire a preset in all its versions, or to restore it.
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
    core::settings::FeelPreset m_base;   ///< the version selected in the list
    core::settings::FeelPreset m_draft;  ///< m_base with the user's changes

    bool m_mayKeep = true;
    bool m_mayRetire = false;
    bool m_otherIsChosen = false;  ///< the user has selected the preset to compare with

    QWidget* m_side = nullptr;  ///< contains the list
    QListWidget* m_list = nullptr;
    QLineEdit* m_name = nullptr;
    QLineEdit* m_notes = nullptr;
    QLabel* m_version = nullptr;
    QStackedWidget* m_ways = nullptr;
    SimplePanel* m_simple = nullptr;
    PresetTable* m_table = nullptr;
    FeedChart* m_chart = nullptr;
    QBoxLayout* m_middle = nullptr;  ///< contains the numbers and the chart
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
