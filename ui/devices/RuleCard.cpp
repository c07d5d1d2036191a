// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/RuleCard.h"

#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QVBoxLayout>

#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

constexpr int kRulePx = 74;

}  // namespace

RuleCard::RuleCard(QWidget* parent)
    : QFrame(parent), m_words(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this)),
      m_rule(new QPlainTextEdit(this)), m_copy(new QPushButton(this))
{
    setProperty("kind", "card");
    setObjectName(QStringLiteral("rule"));
    m_rule->setObjectName(QStringLiteral("ruleText"));
    m_rule->setReadOnly(true);
    m_rule->setTabChangesFocus(true);
    m_rule->setFixedHeight(kRulePx);
    m_rule->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_copy->setObjectName(QStringLiteral("copyRule"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    column->setSpacing(kSpace2);
    column->addWidget(m_words);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace4);
    row->addWidget(m_rule, 1);
    row->addWidget(m_copy, 0, Qt::AlignTop);
    column->addLayout(row);
    connect(m_copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(m_rule->toPlainText()); });
    text::bindTranslation(this, [this] {
        m_copy->setText(tr("Copy the rule"));
        m_copy->setAccessibleName(m_copy->text());
        m_rule->setAccessibleName(tr("Rule for this device"));
        describe();
    });
}

void RuleCard::setKind(const DeviceKind& kind)
{
    m_kind = kind;
    describe();
}

void RuleCard::describe()
{
    m_rule->setPlainText(m_kind.rule);
    //: %1: a file; %2: a command
    m_words->setText(tr("As an administrator, write this rule to the file %1. Then unplug the device and plug it in "
                        "again. The command \"%2\" prints the same rule.")
                         .arg(m_kind.ruleFile, m_kind.ruleCommand));
}

}  // namespace ui::devices
