//! What binds tighter.

use super::model;
use crate::model::{Binary, Expr};

/// The expression with all parentheses written.
fn shown(expr: &Expr) -> String {
    match expr {
        Expr::Number(value) => format!("{value}"),
        Expr::Time => "t".into(),
        Expr::Negate(inner) => format!("(-{})", shown(inner)),
        Expr::Power(base, exponent) => format!("({}^{})", shown(base), shown(exponent)),
        Expr::Binary(operator, a, b) => {
            let operator = match operator {
                Binary::Add => '+',
                Binary::Subtract => '-',
                Binary::Multiply => '*',
                Binary::Divide => '/',
            };
            format!("({}{operator}{})", shown(a), shown(b))
        }
        other => format!("{other:?}"),
    }
}

fn parsed(expr: &str) -> String {
    let text = format!(
        "model M {{
            material steel {{ density = 1 kg/m^3; young = 1 Pa; }}  section thin {{ area = 1 m^2; second_moment = 1 m^4; }}
            body b {{ spatial; line from [0, 0, 0] to [1, 0, 0] m; mesh 1 * cable(thin, steel); }}
            joint j = pin(b.start, inertial);
            output x = {expr};
        }}"
    );
    shown(&model(&text).outputs[0].components[0].1)
}

#[test]
fn precedence() {
    for (text, want) in [
        ("t^2/2", "((t^2)/2)"),
        ("-t^2", "(-(t^2))"),
        ("2^3^2", "(2^(3^2))"),
        ("2^-3", "(2^(-3))"),
        ("2*-3", "(2*(-3))"),
        ("1 - 2 - 3", "((1-2)-3)"),
        ("8/4/2", "((8/4)/2)"),
        ("1 + 2*3^4", "(1+(2*(3^4)))"),
        ("(1 + 2)*3", "((1+2)*3)"),
        ("--2", "(-(-2))"),
        ("-2 + 3", "((-2)+3)"),
        ("2 m / 4 s * t", "((2/4)*t)"),
        ("3 [m/s^2] * t", "(3*t)"),
        ("(2 m)^2", "(2^2)"),
        ("3 m^2", "3"),
        ("-3 N m", "(-3)"),
        ("3 W/(m K)", "3"),
        ("2 km/s", "2000"),
        ("t/2 ms", "(t/0.002)"),
    ] {
        assert_eq!(parsed(text), want, "{text}");
    }
}
