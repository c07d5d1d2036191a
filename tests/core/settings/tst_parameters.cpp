// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include "core/settings/Parameters.h"
#include "tests/support/Suite.h"

using core::settings::Parameter;
using core::settings::Parameters;
using Outcome = core::settings::SetAnswer::Outcome;

namespace {

struct Numbers
{
    double stiffness = 2.0;
    double isWet = 0.0;
    Parameters parameters;

    Numbers()
    {
        Parameter stiff{"force.stiffness",
                        "N/mm",
                        0.2,
                        20.0,
                        false,
                        [this] { return stiffness; },
                        [] { return 2.0; },
                        [this](double value) -> std::string {
                            if (value > 10.0)
                                return "it would tremble";
                            stiffness = value;
                            return {};
                        },
                        [] { return "Stiffness"; },
                        [] { return "how hard"; }};
        parameters.add(std::move(stiff));
        Parameter wet;
        wet.name = "view.wet";
        wet.isSwitch = true;
        wet.read = [this] { return isWet; };
        wet.initial = [] { return 0.0; };
        wet.write = [this](double value) {
            isWet = value;
            return std::string();
        };
        parameters.add(std::move(wet));
        Parameter live;
        live.name = "live.force";
        live.read = [] { return 0.5; };
        parameters.add(std::move(live));
    }
};

}  // namespace

class TestParameters : public QObject
{
    Q_OBJECT
private slots:
    void areFoundByName()
    {
        const Numbers numbers;
        const auto all = numbers.parameters.matching({});
        QCOMPARE(all.size(), std::size_t{3});
        QCOMPARE(all[0]->name, std::string("force.stiffness"));
        QCOMPARE(all[2]->name, std::string("view.wet"));
        QCOMPARE(numbers.parameters.matching("force").size(), std::size_t{2});
        QCOMPARE(numbers.parameters.beginningWith("force").size(), std::size_t{1});
        QVERIFY(numbers.parameters.find("force") == nullptr);
        QCOMPARE(numbers.parameters.find("force.stiffness")->read(), 2.0);
    }

    void onlyWhatIsAllowedIsSet()
    {
        const Numbers numbers;
        const auto set = [&](const char* name, double value) { return numbers.parameters.set(name, value).outcome; };
        QCOMPARE(set("force.stiffness", 3.5), Outcome::Done);
        QCOMPARE(numbers.stiffness, 3.5);
        QCOMPARE(set("force.stiffness", 0.1), Outcome::OutOfRange);
        QCOMPARE(set("force.stiffness", 20.1), Outcome::OutOfRange);
        QCOMPARE(set("force.stiffness", std::nan("")), Outcome::NotANumber);
        QCOMPARE(set("force.stiffness", INFINITY), Outcome::NotANumber);
        QCOMPARE(numbers.parameters.set("force.stiffness", 12.0).why, std::string("it would tremble"));
        QCOMPARE(numbers.stiffness, 3.5);
        QCOMPARE(set("view.wet", 1.0), Outcome::Done);
        QCOMPARE(set("view.wet", 0.5), Outcome::NotANumber);
        QCOMPARE(set("live.force", 1.0), Outcome::ReadOnly);
        QCOMPARE(set("nobody", 1.0), Outcome::Unknown);
    }

    void goBackToWhatTheyWere()
    {
        const Numbers numbers;
        QCOMPARE(numbers.parameters.set("force.stiffness", 5.0).outcome, Outcome::Done);
        QCOMPARE(numbers.parameters.reset("force.stiffness").outcome, Outcome::Done);
        QCOMPARE(numbers.stiffness, 2.0);
        QCOMPARE(numbers.parameters.reset("live.force").outcome, Outcome::ReadOnly);
        QCOMPARE(numbers.parameters.reset("nobody").outcome, Outcome::Unknown);
    }

    void aNameIsThereOnce()
    {
        Numbers numbers;
        Parameter other;
        other.name = "live.force";
        other.read = [] { return 7.0; };
        numbers.parameters.add(std::move(other));
        QCOMPARE(numbers.parameters.matching({}).size(), std::size_t{3});
        QCOMPARE(numbers.parameters.find("live.force")->read(), 7.0);
    }
};

CUSP_TEST(TestParameters)
#include "tst_parameters.moc"
