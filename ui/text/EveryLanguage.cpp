// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/EveryLanguage.h"

#include <utility>

#include <QEvent>

namespace ui::text {
namespace {

/// Calls a function when the language changes. A widget passes that event on to all its children.
class Sayer final : public QObject
{
public:
    Sayer(QObject* parent, std::function<void()> say) : QObject(parent), m_say(std::move(say)) {}

    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::LanguageChange)
            m_say();
        return QObject::event(event);
    }

private:
    std::function<void()> m_say;
};

}  // namespace

void bindTranslation(QObject* listener, std::function<void()> say)
{
    say();
    new Sayer(listener, std::move(say));
}

}  // namespace ui::text
