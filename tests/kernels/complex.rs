//! Complex numbers for derivatives by complex steps: no difference is taken, so that nothing cancels.

use rncf_codegen::model::Function;
use rncf_codegen::symbolic::Scalar;

/// A complex number.
#[derive(Clone, Copy, Debug)]
pub struct Complex {
    pub re: f64,
    pub im: f64,
}

impl Scalar for Complex {
    fn from_f64(value: f64) -> Self {
        Self { re: value, im: 0.0 }
    }
    fn real(self) -> f64 {
        self.re
    }
    fn add(self, other: Self) -> Self {
        Self {
            re: self.re + other.re,
            im: self.im + other.im,
        }
    }
    fn subtract(self, other: Self) -> Self {
        Self {
            re: self.re - other.re,
            im: self.im - other.im,
        }
    }
    fn multiply(self, other: Self) -> Self {
        Self {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
    fn divide(self, other: Self) -> Self {
        let norm = other.re * other.re + other.im * other.im;
        let product = self.multiply(Self {
            re: other.re,
            im: -other.im,
        });
        Self {
            re: product.re / norm,
            im: product.im / norm,
        }
    }
    fn call(self, function: Function) -> Self {
        // First order in the imaginary part is exact for a step of 1e-200.
        match function {
            Function::Sqrt => {
                let root = self.re.sqrt();
                Self {
                    re: root,
                    im: 0.5 * self.im / root,
                }
            }
            Function::Sin => Self {
                re: self.re.sin(),
                im: self.re.cos() * self.im,
            },
            Function::Cos => Self {
                re: self.re.cos(),
                im: -self.re.sin() * self.im,
            },
            other => panic!("{other:?} occurs in no kernel"),
        }
    }
    fn call2(self, function: Function, _: Self) -> Self {
        panic!("{function:?} occurs in no kernel")
    }
}
