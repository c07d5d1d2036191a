// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings/SettingsPage.h"

#include <algorithm>

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShowEvent>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/console/ParameterWords.h"
#include "ui/kit/Actions.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/LanguageMenu.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Language.h"
#include "ui/text/Search.h"

namespace ui::settings {
namespace {

using namespace ui::kit;

constexpr int kWidestPx = 760;
constexpr int kLabelPx = 230;
constexpr int kChoicePx = 28;
constexpr int kNumberPx = 150;
constexpr int kDecimals = 3;

QString groupOf(const core::settings::Parameter& parameter)
{
    return QString::fromStdString(parameter.name).section(u'.', 0, 0);
}

}  // namespace

SettingsPage::SettingsPage(const Actions& actions, const core::settings::Parameters& parameters, QWidget* parent)
    : Page(actions, parent), m_actions(actions), m_parameters(parameters), m_search(new QLineEdit(this)),
      m_fault(kit::faultLabel(this)), m_blind(kit::formWords({}, kBody, QFont::Medium, QPalette::WindowText, this)),
      m_content(new QWidget(this)), m_column(new QVBoxLayout(m_content)),
      m_none(kit::formWords({}, kBody, QFont::Normal, QPalette::PlaceholderText, this))
{
    m_search->setClearButtonEnabled(true);
    m_search->setMaximumWidth(kWidestPx);
    m_search->setObjectName(QStringLiteral("settingsSearch"));
    m_fault->setObjectName(QStringLiteral("settingsFault"));
    m_blind->setMaximumWidth(kWidestPx);
    m_blind->setObjectName(QStringLiteral("settingsBlind"));
    m_column->setContentsMargins(0, 0, kSpace4, 0);
    m_column->setSpacing(kSpace2);
    m_content->setMaximumWidth(kWidestPx);
    auto* column = new QVBoxLayout;
    column->setContentsMargins(kSpace4, 0, 0, 0);
    column->setSpacing(kSpace2);
    column->addWidget(m_search);
    column->addWidget(m_fault);
    column->addWidget(m_blind);
    column->addWidget(m_none);
    m_none->setObjectName(QStringLiteral("noSetting"));
    column->addWidget(new ScrollPane(m_content, QPalette::Window, this), 1);
    body()->addLayout(column, 1);
    connect(m_search, &QLineEdit::textChanged, this, &SettingsPage::search);
    text::bindTranslation(this, [this] {
        setTitle(tr("Settings"));
        m_search->setPlaceholderText(tr("Search the settings"));
        m_search->setAccessibleName(tr("Search the settings"));
        for (auto* clear : m_search->findChildren<QAbstractButton*>())
            clear->setAccessibleName(tr("Clear the search"));
        m_none->setText(tr("No setting is called so, and none speaks of it. Look for one word, such as \"force\"."));
        kit::showFault(m_fault, {});  // its text is in the previous language
        m_blind->setText(console::blindWords());
        fill();
    });
}

void SettingsPage::fill()
{
    m_rows.clear();
    while (QLayoutItem* item = m_column->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    addWindowRows();
    QString group;
    QLabel* heading = nullptr;
    for (const core::settings::Parameter* parameter : m_parameters.matching({})) {
        if (parameter->isLive())
            continue;
        if (const QString own = groupOf(*parameter); own != group) {
            group = own;
            heading =
                kit::formWords(console::groupName(group), kTitle, QFont::DemiBold, QPalette::WindowText, m_content);
            heading->setContentsMargins(0, kSpace4, 0, 0);
            m_column->addWidget(heading);
        }
        Row row;
        row.group = heading;
        row.name = parameter->name;
        row.words = QString::fromStdString(parameter->name + ' ' + parameter->label() + ' ' + parameter->help());
        row.whole = makeRow(*parameter, m_content, row);
        m_column->addWidget(row.whole);
        m_rows.push_back(std::move(row));
    }
    m_column->addStretch(1);
    search(m_search->text());
    refresh();
}

/// Adds rows for settings of the program that are not parameters.
void SettingsPage::addWindowRows()
{
    auto* heading = kit::formWords(tr("Window"), kTitle, QFont::DemiBold, QPalette::WindowText, m_content);
    m_column->addWidget(heading);
    const auto addRow = [&](const QString& label, QWidget* input, const QString& help) {
        auto* whole = new QWidget(m_content);
        auto* line = new QHBoxLayout(whole);
        line->setContentsMargins(0, 0, 0, 0);
        line->setSpacing(kSpace4);
        auto* words = kit::formWords(label, kBody, QFont::Normal, QPalette::WindowText, whole);
        words->setFixedWidth(kLabelPx);
        line->addWidget(words);
        line->addWidget(input);
        line->addWidget(kit::formWords(help, kSmall, QFont::Normal, QPalette::PlaceholderText, whole), 1);
        m_column->addWidget(whole);
        m_rows.push_back({whole, heading, {}, QStringLiteral("%1 %2").arg(label, help), [] {}});
    };
    const auto add = [&](const char* name, const QString& label, const QString& help) {
        auto* choice = kit::choiceInput(label, m_content);
        choice->setObjectName(QLatin1String(name));
        choice->setMinimumWidth(kNumberPx);
        choice->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);  // as wide as its text in this language
        choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        addRow(label, choice, help);
        return choice;
    };
    QComboBox* language = add("language", tr("Language"), tr("Of every window, at once."));
    for (const QString& code : text::Language::available()) {
        language->addItem(text::Language::nameOf(code), code);
        // Text in another font may be higher, so all rows get the same height.
        language->setItemData(language->count() - 1, QSize(kNumberPx, kChoicePx), Qt::SizeHintRole);
    }
    language->setCurrentIndex(language->findData(text::Language::current()));
    connect(
        language, &QComboBox::activated, this,
        [this](int at) {
            if (const auto* list = findChild<QComboBox*>(QStringLiteral("language")))
                LanguageMenu::choose(list->itemData(at).toString());
        },
        Qt::QueuedConnection);  // the call recreates this list
    QComboBox* theme = add("theme", tr("Pages"), tr("From the next start on. The practice room is always dark."));
    theme->addItem(tr("as the desktop"), static_cast<int>(ThemeChoice::System));
    theme->addItem(tr("light"), static_cast<int>(ThemeChoice::Light));
    theme->addItem(tr("dark"), static_cast<int>(ThemeChoice::Dark));
    theme->setCurrentIndex(theme->findData(static_cast<int>(rememberedTheme())));
    connect(theme, &QComboBox::activated, this,
            [theme] { rememberTheme(static_cast<ThemeChoice>(theme->currentData().toInt())); });
    QPushButton* devices = pageButton(m_actions.devices, "", m_content);
    devices->setObjectName(QStringLiteral("openDevices"));
    devices->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    addRow(tr("Hand"), devices, tr("Mouse or pen, a simulated hand, or a force device: choose, home and try it."));
}

QWidget* SettingsPage::makeRow(const core::settings::Parameter& parameter, QWidget* parent, Row& row)
{
    auto* whole = new QWidget(parent);
    auto* line = new QHBoxLayout(whole);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(kSpace4);
    const QString label = QString::fromStdString(parameter.label());
    const QString help = QString::fromStdString(parameter.help());
    auto* name = kit::formWords(label, kBody, QFont::Normal, QPalette::WindowText, whole);
    name->setFixedWidth(kLabelPx);
    line->addWidget(name);
    const core::settings::Parameter* const bound = &parameter;
    if (parameter.isSwitch) {
        auto* box = new QCheckBox(whole);
        box->setAccessibleName(label);
        box->setFixedWidth(kNumberPx);
        box->setObjectName(QString::fromStdString(parameter.name));
        connect(box, &QCheckBox::toggled, this, [this, key = parameter.name](bool on) { set(key, on ? 1.0 : 0.0); });
        row.show = [box, bound] { box->setChecked(bound->read() != 0.0); };
        line->addWidget(box);
    } else {
        auto* number = kit::numberInput(parameter.minimum, parameter.maximum, kDecimals,
                                        QString::fromStdString(parameter.unit), label, whole);
        number->setFixedWidth(kNumberPx);
        number->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        number->setKeyboardTracking(false);  // a number that is still being typed has no effect
        number->setObjectName(QString::fromStdString(parameter.name));
        connect(number, &QDoubleSpinBox::valueChanged, this,
                [this, key = parameter.name](double value) { set(key, value); });
        row.show = [number, bound] {
            const QString withheld = console::withheldWords(*bound);
            number->setEnabled(withheld.isEmpty());
            number->setToolTip(brokenIntoLines(withheld));
            if (!withheld.isEmpty())
                number->clear();
            else
                number->setValue(bound->read());
        };
        line->addWidget(number);
    }
    auto* words =
        kit::formWords(parameter.isSwitch ? help : help + u' ' + tr("From %1.").arg(console::rangeWords(parameter)),
                       kSmall, QFont::Normal, QPalette::PlaceholderText, whole);
    line->addWidget(words, 1);
    auto* back = new QToolButton(whole);
    back->setIcon(lineIcon(QStringLiteral("undo"), palette()));
    back->setToolTip(tr("Set it back"));
    //: %1 is the name of a setting
    back->setAccessibleName(tr("Set back: %1").arg(label));
    back->setObjectName(QStringLiteral("reset ") + QString::fromStdString(parameter.name));
    back->setAutoRaise(true);
    connect(back, &QToolButton::clicked, this, [this, bound] {
        const auto answer = m_parameters.reset(bound->name);
        kit::showFault(m_fault, console::answerWords(answer, QString::fromStdString(bound->label()), bound));
        refresh();
    });
    line->addWidget(back);
    return whole;
}

void SettingsPage::set(const std::string& name, double value)
{
    if (m_isQuiet)
        return;
    const core::settings::Parameter* parameter = m_parameters.find(name);
    const auto answer = m_parameters.set(name, value);
    kit::showFault(m_fault, console::answerWords(answer, QString::fromStdString(parameter->label()), parameter));
    refresh();
}

void SettingsPage::refresh()
{
    m_isQuiet = true;
    for (const Row& row : m_rows)
        row.show();
    m_isQuiet = false;
    m_blind->setVisible(console::isFeelVeiled(m_parameters));
}

/// Hides the message about an earlier refusal.
void SettingsPage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    if (!event->spontaneous())
        kit::showFault(m_fault, {});
}

void SettingsPage::search(const QString& words)
{
    for (const Row& row : m_rows)
        row.whole->setVisible(text::holds(row.words, words));
    m_none->setVisible(
        std::none_of(m_rows.begin(), m_rows.end(), [&](const Row& row) { return text::holds(row.words, words); }));
    for (const Row& row : m_rows)
        row.group->setVisible(std::any_of(m_rows.begin(), m_rows.end(), [&](const Row& other) {
            return other.group == row.group && text::holds(other.words, words);
        }));
}

}  // namespace ui::settings
