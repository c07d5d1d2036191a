// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <QJsonArray>
#include <QJsonObject>
#include <QString>

#include "lessons/PresetFile.h"
#include "ui/shell/Page.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;
class QStackedWidget;

namespace ui::presets {

class FeedChart;
class PresetTable;
class SimplePanel;

/// The hardness presets there are, each in all its versions, and one of them to be looked at, tried, turned and kept as
/// another version. Whatever is asked of files and of the servo goes out by signals.
class PresetsPage : public shell::Page
{
    Q_OBJECT
public:
    PresetsPage(const shell::Actions& actions, QWidget* parent);

    /// What is on the shelf. What is being turned stays.
    void setPresets(std::vector<lessons::ReadPreset> all, const core::settings::FeelPreset& inUse);
    /// Shows this version: it has just been kept.
    void select(const core::settings::FeelPreset& preset);
    /// Takes over what was turned while it was tried: the version on the page, or what was loaded in the console.
    void setDraft(const core::settings::FeelPreset& preset);
    /// What could not be done, beside the buttons, a second line of it quieter; empty: nothing any more.
    void setFault(const QString& sentence);

    /// Who works here now, by his uid, empty: a guest. What another has changed and not kept waits until he is back,
    /// and is shown to nobody else.
    void setWriter(const QString& person);
    /// The writer's versions can be kept, imported and put to use; else they are looked at and tried.
    void setMayKeep(bool may);

    /// The school's presets can be retired, and are seen when they are.
    void setMayRetire(bool may);

    /// What the writer has changed, and could keep, and has not: in a sentence. Empty: nothing.
    [[nodiscard]] QString unkept() const;
    /// What others have changed and could keep, each person's as an object.
    /// @param withOwn  and what the writer has changed
    [[nodiscard]] QJsonArray waiting(bool withOwn) const;
    /// One of those waits again, for who has changed it. False: it is none, or he has changed something else.
    [[nodiscard]] bool goOnWith(const QJsonObject& changed);
    /// One that was refused, in place of what is there. Answers that, which waits in its stead.
    [[nodiscard]] QJsonObject trade(const QJsonObject& changed);
    /// What was refused, in a sentence for who has changed it; empty: it is none.
    [[nodiscard]] static QString words(const QJsonObject& changed);
    /// What this person has changed was kept as this, while another worked here.
    void forget(const QString& person, const core::settings::FeelPreset& kept);

    [[nodiscard]] const core::settings::FeelPreset& draft() const { return m_draft; }
    [[nodiscard]] const std::vector<lessons::ReadPreset>& all() const { return m_all; }

signals:
    /// A preset that is perhaps not kept yet, and the version that it was made of.
    void tryWanted(const core::settings::FeelPreset& base, const core::settings::FeelPreset& preset);
    void compareWanted(const core::settings::FeelPreset& first, const core::settings::FeelPreset& second, int trials);
    /// As another version of its name.
    void saveWanted(const core::settings::FeelPreset& preset);
    /// Teeth are to feel like this from now on, unless a lesson says otherwise.
    void useWanted(const core::settings::FeelPreset& preset);
    /// A preset in all its versions is to be offered to nobody any more, or again.
    void retireWanted(const QString& name, bool isRetired);
    void importWanted();
    void exportWanted(const core::settings::FeelPreset& preset);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// A version, and what has been made of it.
    using Changed = std::pair<core::settings::FeelPreset, core::settings::FeelPreset>;
    /// What waits for somebody.
    struct Waiting
    {
        std::optional<Changed> shown;
        std::optional<Changed> aside;
        bool couldKeep = false;
    };

    QWidget* makeList();
    QWidget* makeDetails();
    QWidget* makePreset(QWidget* parent);
    QWidget* makeAside(QWidget* parent);
    QWidget* makeCompare(QWidget* parent);
    void fit();
    void fill();
    void show(const core::settings::FeelPreset& preset);
    void write(const core::settings::FeelPreset& draft);
    void putAside();
    void tellAside();
    void take(const core::settings::FeelPreset& preset);
    void tell();
    void offerOther();
    void duplicate();
    [[nodiscard]] bool isChanged() const;
    [[nodiscard]] Waiting own() const;
    void takeOver(const Waiting& own);
    [[nodiscard]] static QJsonObject toJson(const QString& person, const Waiting& waits);
    [[nodiscard]] static Waiting fromJson(const QJsonObject& changed);
    [[nodiscard]] bool isNewest() const;
    [[nodiscard]] bool isRetired() const;
    [[nodiscard]] bool mayBeRetired() const;
    [[nodiscard]] std::vector<core::settings::FeelPreset> origins() const;

    std::vector<lessons::ReadPreset> m_all;
    core::settings::FeelPreset m_inUse;
    core::settings::FeelPreset m_base;   ///< the version that is chosen in the list
    core::settings::FeelPreset m_draft;  ///< what has been made of it
    std::optional<Changed> m_putAside;   ///< when another was chosen
    QString m_writer;
    std::map<QString, Waiting> m_waiting;  ///< for who does not work here now

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
    QWidget* m_aside = nullptr;
    QLabel* m_asideWords = nullptr;
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
