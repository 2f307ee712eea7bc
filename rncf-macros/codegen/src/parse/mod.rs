//! Tokens to syntax tree. Reading goes on after a mistake with the next statement, so that one
//! build reports all of them. This grammar is the reference of the language:
//!
//! ```text
//! declaration = { "library" NAME "{" { item } "}" } { doc } [ visibility ] "model" NAME "{" { item } "}"
//! item        = { doc } ( param | const | material | section | element | motion | frame | rigid | body
//!                       | fixture | joint | constraint | spring | state | load | output | run | for
//!                       | component | part )
//! for         = "for" INDEX "in" range "{" { item } "}"   // each NAME is NAME { "[" INDEX "]" }
//! component   = "component" NAME "(" [ told { "," told } ] ")" "{" { item } "}"
//! told        = NAME ":" kind [ "=" expr ]      // kind: a unit, angle number count vector place frame body joint motion ..
//! part        = "part" NAME "=" call ";"        // the name of a component
//! range       = "0" ".." expr                   // a count
//! param       = "param" NAME [ ":" "count" ] "=" right ";"
//! const       = "const" NAME "=" right ";"
//! material    = "material" NAME fields          // density young poisson damping yield energy
//! section     = "section" NAME fields           // area second_moment torsion_constant shear_factor extent_y ..
//!             | "section" NAME "=" call ";"     // circle(radius = ..), tube(radius = .., thickness = ..), rectangle(y = .., z = ..)
//! element     = "element" NAME "(" "section" "," "material" ")" "{" { { doc } part ";" } "}"
//! part        = "domain" NAME "in" "0..1" | "also" NAME | "points" WHOLE
//!             | "vector" NAME "=" DERIVATIVE "at" expr "," "shape" expr     // r r_x r_y r_z; 0..1; a polynomial
//!             | "field" NAME "=" DERIVATIVE                                 // r_x r_xx r_y r_yx ..
//!             | "coefficient" NAME ":" unit "=" right | "inertia" DERIVATIVE "=" COEFFICIENT | "damping" "=" expr
//!             | "option" NAME "=" VALUE { "|" VALUE }
//!             | ( "let" | "strain" ) NAME when "=" expr
//!             | "energy" NAME when "=" expr [ "," "stress" expr ] [ "," "points" ( WHOLE | "nodes" ) ]
//! when        = [ "when" OPTION "is" VALUE { "and" OPTION "is" VALUE } ] [ "in" ( "plane" | "space" ) ]
//! motion      = "motion" NAME "(" "t" ")" "=" right ";"
//! frame       = "frame" NAME [ "in" FRAME ] "=" call ";"
//!                   // rotating(axis = x|y|z|vector, angle = expr [, origin = vector])
//!                   // moving(origin = vector)
//!                   // free([origin = vector, axis = .., angle = .., velocity = vector, angular_velocity = vector])
//!                   // free(plane = xy|yz|zx [, origin = .., angle = .., velocity = .., speed = expr])
//!                   // turning([axis = .., angle = .., angular_velocity = vector])
//!                   // hinged(axis = .. [, angle = expr, speed = expr])
//! rigid       = "rigid" NAME [ "in" FRAME ] fields
//!                   // mass inertia center plane, and those of free(..); `plane xy;` needs no "="
//! body        = "body" NAME [ "in" FRAME ] "{" { statement } "}"
//! statement   = "planar" ( "xy" | "yz" | "zx" ) ";"
//!             | "spatial" ";"
//!             | "line" "from" vector "to" vector ";"
//!             | "arc" "from" vector "direction" vector [ "normal" vector ] "radius" expr "angle" expr ";"
//!             | "curve" ( "through" TABLE [ "from" "direction" vector ] [ "to" "direction" vector ] | vector "for" NAME "from" expr "to" expr ) ";"
//!             | "section_y" vector ";" | "twist" right ";"
//!             | ("mean_axes" | "chord") ";"
//!             | ( "modal" | "small" ) "(" expr ")" ";" | "rigid" ";" | "point" ";"
//!             | "mesh" primary "*" call ";"     // element(section, material [, option = value])
//! fixture     = "fixture" NAME "on" PLACE fields
//!                   // FRAME[.at(vector)]: mass inertia; BODY.end|..: mass offset gyration
//! joint       = "joint" NAME "=" call ";"       // clamp|clamp_full|pin(BODY.end, FRAME [, at = vector])
//!                   // share|merge(BODY.end, BODY.end)
//!                   // KIND(PLACE, PLACE [, axis = .., cross = .., length = expr]), hold(BODY.end.z),
//!                   // drive(JOINT.angle|JOINT.slide|FRAME.angle, expr)
//! constraint  = "constraint" NAME "=" expr ";"  // scalar or vector, = 0
//! spring      = "spring" NAME "=" call ";"      // linear(PLACE, PLACE, stiffness = .., length = .. [, damping = ..])
//!                   // law(PLACE, PLACE, force = expr), torsional(JOINT|FRAME, stiffness = .. [, damping = .., angle = ..])
//!                   // torsional_law(JOINT|FRAME, moment = expr), coordinate(expr, stiffness = .. [, damping = .., value = ..])
//!                   // coordinate_law(expr, force|moment = expr)
//! state       = "state" NAME "=" call ";"       // integral(expr, start = expr [, size = expr])
//! load        = "load" NAME "=" call ";"        // gravity(vector), follower(BODY.end, expr | [expr, expr])
//!                   // force|moment(BODY.end|BODY.at(expr), vector [, in = FRAME])
//! output      = "output" NAME "=" right ";"
//! run         = "run" fields                    // t_end every start
//! fields      = "{" { NAME "=" right ";" } "}"
//!
//! right       = [ "-" ] NUMBER unit | expr      // a whole right side may be literal plus any unit
//! expr        = product { ( "+" | "-" ) product }
//! product     = signed { ( "*" | "/" | "%" ) signed }     // "%" in the number of a repetition
//! signed      = "-" signed | power
//! power       = member [ "^" signed ]           // binds tightest, from the right
//! member      = primary { "." NAME [ "(" arguments ")" ] | "[" expr "]" | "(" arguments ")" }
//! primary     = NUMBER [ SYMBOL | "[" unit "]" ] // in an expression: one symbol, or brackets
//!             | NAME | NAME "[" expr "]" | call | reduced | "(" expr ")" | vector | if
//! reduced     = ( "max" | "min" | "sum" | "mean" ) "(" INDEX "in" range "," expr ")"
//! if          = "if" expr ( "<" | "<=" | ">" | ">=" ) expr "{" expr "}" "else" ( "{" expr "}" | if )
//! vector      = "[" expr "," expr "," expr "]" [ unit ]
//! call        = NAME "(" arguments ")"
//! arguments   = [ argument { "," argument } [ "," ] ]
//! argument    = expr | NAME "=" right
//! unit        = factor { ( "*" | "/" | nothing ) factor }   // nothing: not behind a "/"
//! factor      = SYMBOL [ "^" [ "-" ] WHOLE ] | "1" | "(" unit ")"
//! ```
//!
//! Items may be used before they are declared. A unit behind a vector is that of its plain
//! numbers; values of its dimension may stand beside them. A bare `0` needs no unit in a vector.
//! `t` is time: tonnes are written `[t]`, or as the first symbol of a compound unit. In outputs,
//! `BODY.start`, `BODY.end` and `BODY.at(expr)` have `x y z` (also as `position.x`), `velocity`
//! and `slope`; joints have `force` and `moment`; without a component the output is a vector.

pub mod ascii;
pub(crate) mod component;
pub(crate) mod cursor;
mod documentation;
mod element;
mod expr;
mod import;
mod item;
pub mod library;
mod messages;
mod recover;
mod repeat;
mod source;
mod statement;
mod table;
pub mod tree;
pub(crate) mod unit;

#[cfg(test)]
mod tests;

use proc_macro2::{Delimiter, Group, Span, TokenStream, TokenTree};

use crate::errors::{Errors, Mistake};
use cursor::{Cursor, Parsed};
use messages as say;
use tree::{Name, Tree};

/// Reads a declaration; all mistakes go to `errors`. A tree comes back as soon as the model's name
/// could be read, with all items that could be; `None` where not even that.
pub fn parse(tokens: TokenStream, errors: &mut Errors) -> Option<Tree> {
    let mut cursor = Cursor::new(tokens, Span::call_site());
    let before = errors.len();
    let read = library::taken_in(&mut cursor, errors).and_then(|libraries| Ok((libraries, head(&mut cursor, errors)?)));
    let (libraries, mut tree) = match read {
        Ok(read) => read,
        Err(mistake) => {
            errors.push(mistake);
            return None;
        }
    };
    match body(&mut cursor, &tree.name) {
        Ok(group) => {
            library::take_in(&libraries, &mut tree, errors);
            item::items(&mut Cursor::of(&group), &mut tree, None, errors);
            tree.source = source::declaration(&tree, &group);
        }
        Err(mistake) => errors.push(mistake),
    }
    if !cursor.is_empty() && errors.len() == before {
        errors.at(cursor.here(), say::after_model(&cursor.found()));
    }
    tree.complete = errors.len() == before;
    Some(tree)
}

/// Documentation, visibility, `model`, name.
fn head(cursor: &mut Cursor, errors: &mut Errors) -> Parsed<Tree> {
    let doc = documentation::documentation(cursor, errors);
    let visibility = visibility(cursor);
    if !cursor.eat_word("model") {
        return Err(cursor.expected("`model Name { .. }`"));
    }
    let name = cursor.expect_name("the name of the model")?;
    item::check_name(&name)?;
    let folder = std::env::var_os("CARGO_MANIFEST_DIR");
    Ok(Tree {
        doc,
        visibility,
        folder: folder.map(Into::into).unwrap_or_default(),
        ..Tree::new(name)
    })
}

fn body(cursor: &mut Cursor, name: &Name) -> Parsed<Group> {
    cursor.eat_group(Delimiter::Brace).ok_or_else(|| {
        let place = if cursor.is_empty() { name.span } else { cursor.here() };
        Mistake::new(
            place,
            say::expected(&format!("`{{` after `model {}`", name.text), &cursor.found()),
        )
    })
}

/// `pub`, `pub(crate)`, `pub(in path)` or nothing.
fn visibility(cursor: &mut Cursor) -> TokenStream {
    let mut tokens = Vec::new();
    if cursor.is_word("pub") {
        tokens.extend(cursor.next());
        tokens.extend(cursor.eat_group(Delimiter::Parenthesis).map(TokenTree::Group));
    }
    tokens.into_iter().collect()
}
