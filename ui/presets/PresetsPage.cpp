// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/presets/PresetsPage.h"

#include <algorithm>
#include <utility>

#include <QButtonGroup>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "core/bur/Bur.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/Theme.h"
#include "ui/kit/UnsavedChanges.h"
#include "ui/presets/FeedChart.h"
#include "ui/presets/PresetTable.h"
#include "ui/presets/SimplePanel.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/PresetTexts.h"
#include "ui/text/Texts.h"

namespace ui::presets {
namespace {

using core::settings::FeelPreset;
using namespace ui::kit;

constexpr int kListPx = 250;
constexpr int kNarrowListPx = 180;
constexpr int kRowPx = 48;
constexpr int kHighRowPx = 66;  ///< height of three lines
/// Width below which the chart is below the numbers. On such a page, or a low one, parts without enough room scroll.
constexpr int kNarrowestChartPx = 1000;
constexpr int kLowestPx = 560;
constexpr int kLowestChartPx = 240;
constexpr int kTablePx = 600;
constexpr int kBesidePx = 110;  ///< width of margins and scroll bars beside the list and the numbers
constexpr int kOtherPx = 240;
constexpr int kUsualTrials = 8;
constexpr int kMostTrials = 40;

QString nameOf(const FeelPreset& preset)
{
    return QString::fromStdString(preset.name);
}

bool isSameVersion(const FeelPreset& a, const FeelPreset& b)
{
    return a.name == b.name && a.version == b.version;
}

/// Compares two presets except for name, version and hash.
bool isSameFeel(FeelPreset a, const FeelPreset& b)
{
    a.name = b.name;
    a.version = b.version;
    a.hash = b.hash;
    return a == b;
}

/// Enables or disables a button. A disabled button passes the focus to the list, not to the next button, which a second
/// press of Space would trigger by mistake.
void enable(QPushButton* button, bool may, QWidget* list)
{
    if (!may && button->window()->focusWidget() == button)
        list->setFocus();
    button->setEnabled(may);
}

QPushButton* button(const char* kind, const char* name, QWidget* parent)
{
    auto* made = new QPushButton(parent);
    made->setProperty("kind", kind);
    made->setObjectName(QLatin1String(name));
    return made;
}

}  // namespace

PresetsPage::PresetsPage(const Actions& actions, QWidget* parent) : Page(actions, parent)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace6);
    row->addWidget(makeList());
    row->addWidget(makeDetails(), 1);
    body()->addLayout(row, 1);
    text::bindTranslation(this, [this] {
        setTitle(tr("Hardness presets"));
        setFault({});  // its text is in the previous language
        fill();
        tell();
    });
}

QWidget* PresetsPage::makeList()
{
    auto* side = new QWidget(this);
    m_side = side;
    side->setFixedWidth(kListPx);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(kSpace4, 0, 0, 0);
    column->setSpacing(kSpace2);
    m_list = new QListWidget(side);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setProperty("kind", "plain");
    m_list->setObjectName(QStringLiteral("presetList"));
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setSpacing(2);
    connect(m_list, &QListWidget::currentRowChanged, this, [this](int at) {
        if (at >= 0 && m_all[static_cast<std::size_t>(at)].preset)
            choose(*m_all[static_cast<std::size_t>(at)].preset);
    });
    column->addWidget(m_list, 1);
    m_import = button("", "presetImport", side);
    m_export = button("", "presetExport", side);
    m_retire = button("", "presetRetire", side);
    connect(m_retire, &QPushButton::clicked, this, [this] { emit retireRequested(nameOf(m_base), !isRetired()); });
    connect(m_import, &QPushButton::clicked, this, &PresetsPage::importRequested);
    connect(m_export, &QPushButton::clicked, this, [this] { emit exportRequested(m_base); });
    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(kSpace2);
    buttons->addWidget(m_import);
    buttons->addWidget(m_export);
    buttons->addWidget(m_retire);
    column->addLayout(buttons);
    text::bindTranslation(side, [this] {
        m_list->setAccessibleName(tr("Hardness presets and their versions"));
        m_import->setText(tr("Import …"));
        m_import->setAccessibleName(tr("Import a preset"));
        m_import->setToolTip(tr("Read a preset from a file and keep it here"));
        m_export->setText(tr("Export …"));
        m_export->setAccessibleName(tr("Export this version"));
        m_export->setToolTip(tr("Write the chosen version to a file, for another school"));
    });
    return side;
}

QWidget* PresetsPage::makeDetails()
{
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, kSpace4, 0);
    column->setSpacing(kSpace2);
    column->addWidget(makePreset(side), 1);
    m_bound = kit::formWords({}, kBody, QFont::Medium, QPalette::WindowText, side);
    m_bound->setObjectName(QStringLiteral("presetBound"));
    column->addWidget(m_bound);
    column->addWidget(line(side));
    column->addWidget(makeCompare(side));
    m_fault = kit::faultLabel(side);
    m_fault->setObjectName(QStringLiteral("presetFault"));
    column->addWidget(m_fault);
    m_faultDetail = kit::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, side);
    m_faultDetail->setObjectName(QStringLiteral("presetFaultDetail"));
    m_faultDetail->setTextFormat(Qt::PlainText);
    column->addWidget(m_faultDetail);
    m_try = button("filled", "presetTry", side);
    m_save = button("", "presetSave", side);
    auto* copy = button("", "presetCopy", side);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_try);
    buttons->addWidget(m_save);
    buttons->addWidget(copy);
    buttons->addStretch(1);
    column->addLayout(buttons);
    connect(m_try, &QPushButton::clicked, this, [this] { emit tryRequested(m_base, m_draft); });
    connect(m_save, &QPushButton::clicked, this, [this] {
        FeelPreset next = m_draft;
        next.version = 0;
        emit saveRequested(next);
    });
    connect(copy, &QPushButton::clicked, this, &PresetsPage::duplicate);
    text::bindTranslation(side, [this, copy] {
        m_try->setText(tr("Try on a block"));
        m_try->setAccessibleName(m_try->text());
        m_try->setToolTip(tr("Drill a block of enamel, dentin and soft caries with it"));
        copy->setText(tr("Duplicate"));
        copy->setAccessibleName(tr("Duplicate under another name"));
        copy->setToolTip(tr("Begin a preset of another name with these numbers"));
    });
    return side;
}

/// Makes the part with name, notes, numbers and feed chart of a preset.
QWidget* PresetsPage::makePreset(QWidget* parent)
{
    auto* side = new QWidget(parent);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    addHead(column, side);
    auto* choose = new QHBoxLayout;
    auto* simple = button("segment", "presetSimple", side);
    auto* all = button("segment", "presetExpert", side);
    auto* ways = new QButtonGroup(side);
    for (QPushButton* way : {simple, all}) {
        way->setCheckable(true);
        ways->addButton(way);
        choose->addWidget(way);
    }
    simple->setChecked(true);
    choose->addStretch(1);
    auto* bur = kit::choiceInput({}, side);
    bur->setObjectName(QStringLiteral("presetBur"));
    auto* burName = new QLabel(side);
    burName->setBuddy(bur);
    choose->addWidget(burName);
    choose->addWidget(bur);
    column->addLayout(choose);

    addNumbers(column, side);
    connect(simple, &QPushButton::clicked, this, [this] {
        m_simple->setPreset(origins(), m_draft);
        m_ways->setCurrentIndex(0);
        fit();
    });
    connect(all, &QPushButton::clicked, this, [this] {
        m_table->setPreset(m_draft);
        m_ways->setCurrentIndex(1);
        fit();
    });
    connect(bur, &QComboBox::currentIndexChanged, this, [this](int index) {
        if (index >= 0)
            m_chart->setTool(static_cast<std::size_t>(index));
    });
    text::bindTranslation(side, [this, simple, all, bur, burName] {
        simple->setText(tr("Simple"));
        simple->setToolTip(tr("A few sliders"));
        all->setText(tr("All numbers"));
        all->setToolTip(tr("Every number with its range"));
        for (QPushButton* way : {simple, all})
            way->setAccessibleName(way->text());
        burName->setText(tr("Feed of"));
        bur->setAccessibleName(tr("Bur whose feed is drawn"));
        bur->view()->setAccessibleName(bur->accessibleName());
        const int at = std::max(0, bur->currentIndex() < 0 ? 1 : bur->currentIndex());
        const QSignalBlocker quiet(bur);
        bur->clear();
        for (const core::bur::Bur& one : core::bur::burs())
            bur->addItem(text::burName(one.id));
        bur->setCurrentIndex(at);
    });
    return new ScrollPane(side, QPalette::Window, parent);
}

/// Adds the name, version and notes of a preset.
void PresetsPage::addHead(QVBoxLayout* column, QWidget* side)
{
    auto* head = new QHBoxLayout;
    m_name = new QLineEdit(side);
    m_name->setObjectName(QStringLiteral("presetName"));
    m_name->setMaxLength(static_cast<int>(lessons::kLongestPresetName));
    m_name->setMaximumWidth(280);
    m_version = kit::formWords({}, kBody, QFont::Normal, QPalette::PlaceholderText, side);
    m_version->setObjectName(QStringLiteral("presetVersion"));
    m_version->setTextFormat(Qt::PlainText);
    m_use = button("", "presetUse", side);
    head->addWidget(m_name);
    head->addWidget(m_version, 1);
    head->addWidget(m_use);
    column->addLayout(head);
    m_notes = new QLineEdit(side);
    m_notes->setMaxLength(static_cast<int>(lessons::kLongestPresetNotes));
    m_notes->setObjectName(QStringLiteral("presetNotes"));
    column->addWidget(m_notes);
    connect(m_name, &QLineEdit::textEdited, this, [this](const QString& name) {
        m_draft.name = name.trimmed().toStdString();
        tell();
    });
    connect(m_notes, &QLineEdit::textEdited, this, [this](const QString& notes) {
        m_draft.notes = notes.toStdString();
        tell();
    });
    connect(m_use, &QPushButton::clicked, this, [this] { emit useRequested(m_base); });
    text::bindTranslation(side, [this] {
        m_name->setAccessibleName(tr("Name of the preset"));
        m_name->setPlaceholderText(tr("Name"));
        m_notes->setAccessibleName(tr("Notes"));
        m_notes->setPlaceholderText(tr("Notes: what it is for"));
        m_use->setText(tr("Use for practice"));
        m_use->setAccessibleName(tr("Use this version for practice"));
        m_use->setToolTip(tr("Every tooth feels like this, unless its lesson says otherwise"));
    });
}

/// Adds the numbers of a preset, as simple sliders or as a table, and its feed chart.
void PresetsPage::addNumbers(QVBoxLayout* column, QWidget* side)
{
    m_middle = new QBoxLayout(QBoxLayout::LeftToRight);
    m_middle->setSpacing(kSpace6);
    m_ways = new QStackedWidget(side);
    auto* dials = new QWidget(m_ways);
    auto* dialColumn = new QVBoxLayout(dials);
    dialColumn->setContentsMargins(0, kSpace2, kSpace4, 0);
    m_simple = new SimplePanel(dials);
    dialColumn->addWidget(m_simple);
    dialColumn->addStretch(1);
    m_table = new PresetTable(m_ways);
    m_ways->addWidget(new ScrollPane(dials, QPalette::Window, m_ways));
    m_ways->addWidget(new ScrollPane(m_table, QPalette::Window, m_ways));
    m_ways->setMaximumWidth(kTablePx);
    m_chart = new FeedChart(side);
    m_middle->addWidget(m_ways, 5);  // with its help in two lines, fits a window of 1280 by 800
    m_middle->addWidget(m_chart, 3);
    column->addLayout(m_middle, 1);
    connect(m_simple, &SimplePanel::changed, this, &PresetsPage::take);
    connect(m_table, &PresetTable::changed, this, &PresetsPage::take);
}

QWidget* PresetsPage::makeCompare(QWidget* parent)
{
    auto* whole = new QWidget(parent);
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 0);
    auto* words = new QLabel(whole);
    m_other = kit::choiceInput({}, whole);
    m_other->setObjectName(QStringLiteral("presetOther"));
    m_other->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_other->setMinimumContentsLength(5);
    words->setBuddy(m_other);
    m_other->setMaximumWidth(kOtherPx);
    m_trials = kit::countInput(1, kMostTrials, whole);
    m_trials->setObjectName(QStringLiteral("presetTrials"));
    m_trials->setValue(kUsualTrials);
    m_compare = button("", "presetCompare", whole);
    row->addWidget(words);
    row->addWidget(m_other, 1);
    row->addWidget(m_trials);
    row->addWidget(m_compare);
    row->addStretch(1);
    connect(m_other, &QComboBox::activated, this, [this] {
        m_otherIsChosen = true;
        offerOther();
    });
    connect(m_compare, &QPushButton::clicked, this, [this] {
        const int at = m_other->currentData().toInt();
        if (m_other->currentIndex() >= 0 && m_all[static_cast<std::size_t>(at)].preset)
            emit compareRequested(m_draft, *m_all[static_cast<std::size_t>(at)].preset, m_trials->value());
    });
    text::bindTranslation(whole, [this, words] {
        words->setText(tr("Compare blind with"));
        m_other->setAccessibleName(tr("Preset to compare with"));
        m_other->view()->setAccessibleName(m_other->accessibleName());
        m_trials->setAccessibleName(tr("Number of trials"));
        //: Before a number
        m_trials->setPrefix(tr("Trials:") + u' ');
        m_compare->setText(tr("Compare A and B"));
        m_compare->setAccessibleName(m_compare->text());
    });
    return whole;
}

void PresetsPage::setPresets(std::vector<lessons::ReadPreset> all, const FeelPreset& inUse)
{
    // Follows a change of the preset in use, as at a login, unless the user is viewing another preset.
    const bool follows =
        m_all.empty() || (!isChanged() && isSameVersion(m_base, m_inUse) && !isSameVersion(m_inUse, inUse));
    m_all = std::move(all);
    if (!m_mayRetire)
        std::erase_if(m_all, [&](const lessons::ReadPreset& read) {
            return read.isRetired && read.preset && !isSameVersion(*read.preset, inUse);
        });
    m_inUse = inUse;
    fill();
    if (follows)
        select(inUse);
    tell();
}

void PresetsPage::fill()
{
    const QSignalBlocker quiet(m_list);
    const QString other = m_other->currentText();
    m_list->clear();
    m_other->clear();
    for (std::size_t k = 0; k < m_all.size(); ++k) {
        const lessons::ReadPreset& read = m_all[k];
        if (!read.preset) {
            const QString words = text::faultWords(read);
            auto* item = new QListWidgetItem(QStringLiteral("⚠ ") + words, m_list);
            item->setFlags(Qt::NoItemFlags);
            item->setSizeHint({0, kRowPx});
            item->setToolTip(
                brokenIntoLines(read.beyondBound ? QFileInfo(read.file).fileName() + u'\n' + words : words));
            continue;
        }
        QStringList standing;
        if (isSameVersion(*read.preset, m_inUse))
            standing << tr("in use");
        if (read.file.isEmpty())
            standing << tr("shipped");
        if (read.isRetired)
            //: A hardness preset that nobody is offered any more
            standing << tr("retired");
        QStringList lines{nameOf(*read.preset), tr("version %1").arg(read.preset->version)};
        if (!standing.isEmpty())  // beside the version, only English would fit
            lines << standing.join(QStringLiteral(" · "));
        auto* item = new QListWidgetItem(lines.join(u'\n'), m_list);
        item->setSizeHint({0, standing.isEmpty() ? kRowPx : kHighRowPx});  // the width is that of the list
        item->setToolTip(brokenIntoLines((QStringList(text::presetWords(*read.preset)) + standing).join(u" · ")));
        if (isSameVersion(*read.preset, m_base))
            m_list->setCurrentItem(item);
        if (read.isRetired)
            continue;
        m_other->addItem(QStringLiteral("%1 v%2").arg(nameOf(*read.preset), QString::number(read.preset->version)),
                         static_cast<int>(k));
    }
    m_other->setCurrentIndex(m_other->findText(other));
}

/// Selects another version to compare: the one that the draft is based on if changed, otherwise the first one with a
/// different feel.
void PresetsPage::offerOther()
{
    const auto at = [this](int row) -> const FeelPreset& {
        return *m_all[static_cast<std::size_t>(m_other->itemData(row).toInt())].preset;
    };
    const int now = m_other->currentIndex();
    if (now < 0 || (!m_otherIsChosen && isSameFeel(at(now), m_draft))) {
        int offered = 0;
        for (int row = m_other->count() - 1; row >= 0; --row)
            if (!isSameFeel(at(row), m_draft) && (offered == 0 || !isSameVersion(at(offered), m_base)))
                offered = row;
        m_other->setCurrentIndex(m_other->count() > 0 ? offered : -1);
    }
    const bool differs = m_other->currentIndex() >= 0 && !isSameFeel(at(m_other->currentIndex()), m_draft);
    enable(m_compare, differs && text::isHeld(m_draft) && !m_draft.name.empty(), m_list);
    m_compare->setToolTip(differs ? tr("Drill with both, behind letters, and say which feels more like a tooth")
                                  : tr("These two feel the same: choose another, or change a number"));
}

void PresetsPage::select(const FeelPreset& preset)
{
    const bool isJustKept = m_draft.name == preset.name && isSameFeel(m_draft, preset);
    if (!isChanged() || isJustKept)
        show(preset);
}

/// Handles the selection of another version in the list.
void PresetsPage::choose(const FeelPreset& preset)
{
    if (isSameVersion(preset, m_base))
        return;
    if (!isChanged()) {
        show(preset);
        return;
    }
    // Queued, because the list has not selected the clicked row yet.
    QMetaObject::invokeMethod(
        this,
        [this, preset] {
            markShown();
            UnsavedChanges::ask(window(), changedWords(), [this, preset] { show(preset); });
        },
        Qt::QueuedConnection);
}

/// Selects the row of the shown preset in the list.
void PresetsPage::markShown()
{
    const QSignalBlocker quiet(m_list);
    for (std::size_t k = 0; k < m_all.size(); ++k)
        if (m_all[k].preset && isSameVersion(*m_all[k].preset, m_base))
            m_list->setCurrentRow(static_cast<int>(k));
}

void PresetsPage::show(const FeelPreset& preset)
{
    setFault({});
    m_base = preset;
    m_otherIsChosen = false;
    markShown();
    write(preset);
}

void PresetsPage::write(const FeelPreset& draft)
{
    m_draft = draft;
    m_name->setText(nameOf(draft));
    m_notes->setText(QString::fromStdString(draft.notes));
    m_simple->setPreset(origins(), draft);
    m_table->setPreset(draft);
    tell();
}

void PresetsPage::setDraft(const FeelPreset& preset)
{
    for (const lessons::ReadPreset& read : m_all)
        if (read.preset && isSameVersion(*read.preset, preset))
            m_base = *read.preset;
    markShown();
    write(preset);
}

/// Applies only the numbers of a preset. Name and notes have fields of their own.
void PresetsPage::take(const FeelPreset& preset)
{
    FeelPreset next = preset;
    next.name = m_draft.name;
    next.version = m_draft.version;
    next.notes = m_draft.notes;
    m_draft = next;
    tell();
}

QString PresetsPage::changedWords() const
{
    //: %1 is a hardness preset
    return tr("What you have changed of the hardness preset %1 is not saved.").arg(text::presetWords(m_base));
}

QString PresetsPage::unsavedChanges() const
{
    return m_mayKeep && isChanged() ? changedWords() : QString();
}

void PresetsPage::discardChanges()
{
    show(m_inUse);
}

bool PresetsPage::isChanged() const
{
    return m_draft.name != m_base.name || !isSameFeel(m_draft, m_base);
}

bool PresetsPage::isNewest() const
{
    return std::none_of(m_all.begin(), m_all.end(), [&](const lessons::ReadPreset& read) {
        return read.preset && read.preset->name == m_base.name && read.preset->version > m_base.version;
    });
}

bool PresetsPage::isRetired() const
{
    return std::any_of(m_all.begin(), m_all.end(), [&](const lessons::ReadPreset& read) {
        return read.isRetired && read.preset && read.preset->name == m_base.name;
    });
}

/// Returns whether the preset may be retired. No version of it may be in use or shipped.
bool PresetsPage::mayBeRetired() const
{
    const auto isNamedSo = [this](const FeelPreset& preset) { return preset.name == m_base.name; };
    const auto& shipped = lessons::shippedPresets();
    return !isNamedSo(m_inUse) && std::none_of(shipped.begin(), shipped.end(), isNamedSo);
}

/// Returns the presets that the sliders may start from: the shipped ones, then the school's own versions, oldest first.
/// The distance of a version from its origin is then the sum of all its changes, however often it was saved in between.
std::vector<FeelPreset> PresetsPage::origins() const
{
    std::vector<FeelPreset> all = lessons::shippedPresets();
    const auto ownFrom = static_cast<std::ptrdiff_t>(all.size());
    for (const lessons::ReadPreset& read : m_all)
        if (read.preset && read.preset->name == m_base.name)
            all.push_back(*read.preset);
    std::sort(all.begin() + ownFrom, all.end(),
              [](const FeelPreset& a, const FeelPreset& b) { return a.version < b.version; });
    all.push_back(m_base);  // may not be in the list
    return all;
}

void PresetsPage::tell()
{
    m_draft.hash = isChanged() ? std::string() : m_base.hash;
    const bool held = text::isHeld(m_draft);
    m_bound->setText((held ? QString() : QStringLiteral("⚠ ")) + text::boundWords(m_draft));
    QPalette colours = palette();
    if (!held)
        colours.setColor(QPalette::WindowText, tones(palette()).harmText);
    m_bound->setPalette(colours);
    m_chart->setPreset(m_draft, m_base);
    const bool isNamed = !m_draft.name.empty();
    m_version->setText(isChanged() ? tr("changed from %1").arg(text::presetWords(m_base))
                                   : tr("version %1").arg(m_base.version) +
                                         QStringLiteral(" (%1)").arg(QString::fromStdString(m_base.hash.substr(0, 8))));
    m_save->setText(!isChanged() && !isNewest() ? tr("Restore as the newest version") : tr("Save as a new version"));
    m_save->setAccessibleName(m_save->text());
    enable(m_save, m_mayKeep && held && isNamed && (isChanged() || !isNewest()), m_list);
    m_save->setToolTip(m_mayKeep ? tr("A version is never changed: this becomes another")
                                 : tr("An admin keeps the school's presets"));
    enable(m_try, held && isNamed, m_list);
    offerOther();
    enable(m_use, m_mayKeep && !isChanged() && !isSameVersion(m_base, m_inUse) && !isRetired(), m_list);
    m_retire->setText(isRetired() ? tr("Take up again") : tr("Retire"));
    m_retire->setAccessibleName(isRetired() ? tr("Offer this preset again") : tr("Retire this preset"));
    m_retire->setToolTip(!mayBeRetired() ? tr("What is in use or shipped is not retired")
                         : isRetired()   ? tr("It is offered again, in all its versions")
                                         : tr("Nobody is offered it any more; attempts go on naming it"));
    m_retire->setVisible(m_mayRetire);
    enable(m_retire, isRetired() || mayBeRetired(), m_list);
    enable(m_export, !isChanged(), m_list);
    enable(m_import, m_mayKeep, m_list);
}

void PresetsPage::duplicate()
{
    //: %1 is the name of a preset that is duplicated
    const QString name = tr("%1 copy").arg(nameOf(m_draft)).left(lessons::kLongestPresetName);
    m_draft.name = name.toStdString();
    m_name->setText(name);
    m_name->setFocus();
    m_name->selectAll();
    tell();
}

void PresetsPage::resizeEvent(QResizeEvent* event)
{
    Page::resizeEvent(event);
    fit();
}

/// Fits the page to its size. If the window is small or the text large, the numbers and the chart keep their heights,
/// and the page scrolls.
void PresetsPage::fit()
{
    const bool isWide = width() >= kNarrowestChartPx;
    const bool isSmall = !isWide || height() < kLowestPx;
    const QWidget* numbers = static_cast<QScrollArea*>(m_ways->currentWidget())->widget();
    m_middle->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    // The actual width may be slightly larger; then the text has fewer lines and some space is left.
    const int across = std::min(kTablePx, width() - kNarrowListPx - kBesidePx);
    m_ways->setMinimumHeight(isSmall ? std::max(numbers->sizeHint().height(), numbers->heightForWidth(across)) : 0);
    m_chart->setMinimumHeight(isSmall ? kLowestChartPx : 0);
    m_side->setFixedWidth(isWide ? kListPx : kNarrowListPx);
}

void PresetsPage::setMayKeep(bool may)
{
    m_mayKeep = may;
    tell();
}

void PresetsPage::setMayRetire(bool may)
{
    m_mayRetire = may;
    tell();
}

void PresetsPage::setFault(const QString& sentence)
{
    kit::showFault(m_fault, sentence.section(u'\n', 0, 0));
    m_faultDetail->setText(sentence.section(u'\n', 1));
    m_faultDetail->setVisible(!m_faultDetail->text().isEmpty());
}

}  // namespace ui::presets
